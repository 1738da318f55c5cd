// Checks that the messages of a stream can be read.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cluster/message.h"
#include "commands/cluster/target.h"

namespace talus::server::cluster_tool {

struct Contents {
  std::uint64_t first = 0;  // first message read
  std::uint64_t last = 0;
  cluster::EnabledFormats enabled;
  struct UnreadMessage {
    std::uint64_t sequence = 0;
    cluster::MessageFault fault;
  };
  std::vector<UnreadMessage> unread;  // only the first few
  std::uint64_t unread_count = 0;
};

/// Reads the newest `max_messages` messages that the stream keeps, one at a time, and calls `on_read` after
/// each. An error is one line: a message could not be fetched.
[[nodiscard]] tl::expected<Contents, std::string> read_contents(
    jetstream::Connection& connection, const Target& target, const store::StoreIdentity& identity,
    std::uint64_t max_messages, const std::function<void(std::uint64_t done, std::uint64_t all)>& on_read);

}  // namespace talus::server::cluster_tool
