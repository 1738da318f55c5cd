// "talusd store": inspects, backs up, restores and repairs the edit store of a data directory, if possible
// while a server uses it.
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

/// Reads a world's file, with its secrets by talusd's settings; an empty path means the built-in world.
using LoadWorld = std::function<tl::expected<std::shared_ptr<const terrain::World>, std::string>(
    const std::filesystem::path&, const SecretLayers&)>;

/// Runs the command and prints its output; `argv[0]` is "store". Returns the exit status.
[[nodiscard]] int store_command(int argc, const char* const* argv, const Environment& environment,
                                const LoadWorld& load_world, const ClusterTools& cluster);

}  // namespace talus::server
