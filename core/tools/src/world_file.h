// The world that a command works on.
#pragma once

#include <string>

#include <talus/terrain/world.h>

#include "failure.h"

namespace talus::tools {

/// The text of a world spec, and the name that errors give it.
struct WorldText {
  std::string toml;
  std::string source;
};

/// The spec in the file at `path`; that of the built-in classic world, which figures of the thesis are drawn
/// from, where `path` is empty.
[[nodiscard]] Expected<WorldText> read_world_text(const std::string& path);

/// The world in that file; the built-in default world where `path` is empty.
[[nodiscard]] Expected<terrain::World> load_world(const std::string& path);

}  // namespace talus::tools
