// "talusd store": looks at, backs up, restores and mends the store of edits in a data directory, while a
// server uses it where that is possible.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include <talus/terrain/world.h>

#include "commands/store/cluster_moves.h"
#include "config/load.h"

namespace talus::server {

/// Reads a world's file; an empty path gives the world built into the program.
using LoadWorld = std::function<tl::expected<std::shared_ptr<const terrain::World>, std::string>(
    const std::filesystem::path&)>;

/// Does what the flags say, and prints; `argv[0]` is "store". Returns the exit status.
[[nodiscard]] int store_command(int argc, const char* const* argv, const Environment& environment,
                                const LoadWorld& load_world, const ClusterTools& cluster);

}  // namespace talus::server
