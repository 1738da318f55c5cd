// "talusd cluster": makes the stream that the servers of one world share, says what keeps them from it, and
// how it is.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <tl/expected.hpp>

#include <talus/voxel/content_hash.h>

#include "cluster/message.h"
#include "config/load.h"

namespace talus::server {

/// The first message of a stream of that world and store, at revision 0. The path of a world's file; empty:
/// the built-in one. An error is one line.
using MakeGenesis = std::function<tl::expected<cluster::Genesis, std::string>(const std::filesystem::path&,
                                                                              const ContentHash& store_id)>;

/// Runs the command; the exit status.
[[nodiscard]] int cluster_command(int argc, const char* const* argv, const Environment& environment,
                                  const MakeGenesis& make_genesis);

}  // namespace talus::server
