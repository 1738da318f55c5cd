// Checks everything that would keep a server from its log, and reports what an operator should know.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cluster/message.h"
#include "commands/cluster/target.h"

namespace talus::server::cluster_tool {

struct Finding {
  enum class Kind : std::uint8_t { ok, note, fault };
  Kind kind = Kind::ok;
  std::string text;  // one line
};

/// Default number of messages read.
inline constexpr std::uint64_t kCheckedMessages = 1'000;

/// Reads the newest `messages` messages of the stream. Stores nothing in it.
[[nodiscard]] std::vector<Finding> check(const Target& target, const cluster::Genesis& genesis,
                                         std::uint64_t messages = kCheckedMessages);

[[nodiscard]] bool any_fault(const std::vector<Finding>& findings);
[[nodiscard]] std::string finding_lines(const std::vector<Finding>& findings);

}  // namespace talus::server::cluster_tool
