// Creates a world's stream and its first message. Leaves correct existing parts unchanged.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "cluster/message.h"
#include "commands/cluster/target.h"

namespace talus::server::cluster_tool {

struct InitResult {
  bool stream = false;
  bool genesis = false;
};

/// Returns what was newly created. An error is one line: NATS forbids it, or a different stream exists.
[[nodiscard]] tl::expected<InitResult, std::string> init(const Target& target,
                                                         const cluster::Genesis& genesis);

[[nodiscard]] std::string made_lines(const Target& target, const cluster::Genesis& genesis,
                                     const InitResult& made);

}  // namespace talus::server::cluster_tool
