// Makes a world's stream, with its first message. What is there and right stays.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "cluster/message.h"
#include "commands/cluster/target.h"

namespace talus::server::cluster_tool {

struct Made {
  bool stream = false;
  bool genesis = false;
};

/// What was made, and was not there before. An error, in one line: NATS does not let it, or what is there is
/// another.
[[nodiscard]] tl::expected<Made, std::string> init(const Target& target, const cluster::Genesis& genesis);

[[nodiscard]] std::string made_lines(const Target& target, const cluster::Genesis& genesis, const Made& made);

}  // namespace talus::server::cluster_tool
