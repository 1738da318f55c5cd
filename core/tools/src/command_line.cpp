#include "command_line.h"

#include "commands/commands.h"

namespace talus::tools {
namespace {

std::vector<Command> add_commands(CLI::App& app) {
  return {add_map(app),     add_section(app), add_export(app), add_hash(app),   add_vox(app),
          add_preview(app), add_find(app),    add_encode(app), add_decode(app), add_explain(app)};
}

}  // namespace

int run_talus_gen(int argc, const char* const* argv, const std::string& version) {
  return run_program(
      {"talus-gen", version,
       "The Talus terrain generator without a network: draws, exports and hashes a world, and encodes and\n"
       "decodes single chunks.\n"
       "Positions are in base voxels, x east and z south, and may be negative: --center -640,32.",
       add_commands},
      argc, argv);
}

}  // namespace talus::tools
