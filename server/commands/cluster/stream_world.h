// Of which world a stream is.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "cluster/message.h"
#include "commands/cluster/target.h"

namespace talus::server::cluster_tool {

/// Reads the oldest message that is kept. An error, in one line: it is of another world or store, or the
/// first and cannot be read. A stream without messages fits.
[[nodiscard]] tl::expected<void, std::string> check_world(jetstream::Connection& connection,
                                                          const Target& target,
                                                          const cluster::Genesis& genesis);

}  // namespace talus::server::cluster_tool
