// All that would keep a server from its log, and what a person should know of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cluster/message.h"
#include "cluster_command/target.h"

namespace talus::server::cluster_tool {

struct Finding {
  enum class Kind : std::uint8_t { ok, note, fault };
  Kind kind = Kind::ok;
  std::string text;  // one line
};

/// Stores nothing in the stream.
[[nodiscard]] std::vector<Finding> check(const Target& target, const cluster::Genesis& genesis);

[[nodiscard]] bool any_fault(const std::vector<Finding>& findings);
[[nodiscard]] std::string finding_lines(const std::vector<Finding>& findings);

}  // namespace talus::server::cluster_tool
