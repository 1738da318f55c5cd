#include "command_line.h"

#include "commands/commands.h"

namespace talus::tools {
namespace {

std::vector<Command> add_commands(CLI::App& app) {
  return {add_gallery(app), add_table1(app), add_likeness(app),      add_lod_error(app),
          add_quality(app), add_erode(app),  add_diamond_square(app)};
}

}  // namespace

int run_talus_thesis(int argc, const char* const* argv, const std::string& version) {
  return run_program(
      {"talus-thesis", version,
       "Evidence for the generator's method: redraws the figures of the thesis (Furtado Machado, KTH, "
       "2019),\n"
       "measures its table 1 again, measures worlds, and makes height maps.\n"
       "Positions are in base voxels, x east and z south, and may be negative: --center -640,32.",
       add_commands},
      argc, argv);
}

}  // namespace talus::tools
