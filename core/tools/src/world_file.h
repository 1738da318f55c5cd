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

/// The spec in the file at `path`; that of the built-in default world where `path` is empty.
[[nodiscard]] Expected<WorldText> read_world_text(const std::string& path);

/// The world that the text of read_world_text() describes.
[[nodiscard]] Expected<terrain::World> load_world(const std::string& path);

}  // namespace talus::tools
