// Checks the world of a stream.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "cluster/message.h"
#include "commands/cluster/target.h"

namespace talus::server::cluster_tool {

/// Reads the oldest kept message. An error is one line: the message is of another world or store, or is the
/// stream's first and unreadable. An empty stream fits.
[[nodiscard]] tl::expected<void, std::string> check_world(jetstream::Connection& connection,
                                                          const Target& target,
                                                          const cluster::Genesis& genesis);

}  // namespace talus::server::cluster_tool
