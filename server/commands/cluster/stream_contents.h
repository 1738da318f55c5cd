// Whether the messages of a stream can be read, one after another.
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
  std::uint64_t first = 0;  // that was read
  std::uint64_t last = 0;
  cluster::EnabledFormats enabled;
  struct Unread {
    std::uint64_t sequence = 0;
    cluster::MessageFault fault;
  };
  std::vector<Unread> unread;  // the first that are
  std::uint64_t unread_count = 0;
};

/// Reads the newest `most` messages of those that the stream keeps, one at a time. `on_read` is called after
/// each. An error, in one line: one does not come.
[[nodiscard]] tl::expected<Contents, std::string> read_contents(
    jetstream::Connection& connection, const Target& target, const store::StoreIdentity& identity,
    std::uint64_t most, const std::function<void(std::uint64_t done, std::uint64_t all)>& on_read);

}  // namespace talus::server::cluster_tool
