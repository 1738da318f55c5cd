// Loads the world of a command.
#pragma once

#include <string>

#include <talus/terrain/world.h>
#include <talus/tools/failure.h>

namespace talus::tools {

/// Text of a world spec, and its name in errors.
struct WorldText {
  std::string toml;
  std::string source;
};

/// Reads the spec at `path`; if empty, returns the spec of the built-in classic world, used for figures of
/// the thesis.
[[nodiscard]] Expected<WorldText> read_world_text(const std::string& path);

/// Loads the world at `path`; if empty, the built-in default world.
[[nodiscard]] Expected<terrain::World> load_world(const std::string& path);

}  // namespace talus::tools
