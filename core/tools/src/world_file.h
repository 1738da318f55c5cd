// The world that a command works on.
#pragma once

#include <string>

#include <talus/terrain/world.h>

#include "failure.h"

namespace talus::tools {

/// The world spec in the file at `path`; the built-in default world where `path` is empty.
[[nodiscard]] Expected<terrain::World> load_world(const std::string& path);

}  // namespace talus::tools
