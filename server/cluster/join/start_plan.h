// Decides how a cluster's server uses the store on its disk before it serves. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <talus/store/records.h>

#include "cluster/log_stream.h"

namespace talus::server::join {

/// True if downloading a peer's checkpoint of `store_bytes` is faster than reading the missing `messages`, of
/// `message_bytes` in total. A wrong guess only costs time.
[[nodiscard]] bool checkpoint_is_quicker(std::uint64_t messages, std::uint64_t message_bytes,
                                         std::uint64_t store_bytes);

struct StartFacts {
  std::optional<store::StoreMeta> local;  // nullopt: no store on the disk, or one without entries
  StreamState stream;
  /// True if the stream's first message is kept and starts with an empty state: the whole stream can be read.
  bool from_nothing = false;
  bool has_peers = false;
  std::uint64_t local_bytes = 0;  // size of the store on the disk
  std::string rejoin{};           // why the store on the disk must not be used; may be empty
  /// One answer reports a different message in place of the local store's last one: acknowledged edits may
  /// exist only in this store.
  bool is_other = false;
};

struct StartPlan {
  enum class Kind : std::uint8_t {
    as_it_is,     // use the store on the disk, and continue the stream
    from_stream,  // start an empty store, and read the whole stream
    from_peer,    // download a peer's checkpoint, and continue the stream
    refused,      // an operator must act
  };
  Kind kind = Kind::refused;
  std::string reason;           // for the log
  bool may_do_without = false;  // from_peer: if no peer has a store, the other ways work too, more slowly
};

[[nodiscard]] StartPlan plan_start(const StartFacts& facts);

/// True if `now` includes everything in `before`: both are of one stream, of which `now` has read at least as
/// much.
[[nodiscard]] bool is_ancestor(const store::StoreMeta& before, const store::StoreMeta& now);

}  // namespace talus::server::join
