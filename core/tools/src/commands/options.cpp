#include "commands/command.h"

namespace talus::tools {

void add_world(CLI::App& command, std::string& world) {
  command.add_option("--world", world, "World spec (world.toml); default: the built-in world")
      ->type_name("FILE");
}

void add_threads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Threads; 0: one a core")
      ->check(CLI::Range(0, 1024))
      ->type_name("N")
      ->capture_default_str();
}

void add_lod(CLI::App& command, std::int64_t& lod) {
  command.add_option("--lod", lod, "Level of detail, 0 to 6: one column spans 2^L base voxels")
      ->type_name("L")
      ->capture_default_str();
}

void add_output(CLI::App& command, std::string& output, const char* meaning, const char* type) {
  command.add_option("-o,--output", output, meaning)->type_name(type)->required();
}

}  // namespace talus::tools
