// What a server of a cluster does with the store that it finds on its disk, before it serves. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <talus/store/records.h>

#include "cluster/log_stream.h"

namespace talus::server::join {

/// Whether a store of `store_bytes` is sooner here as a peer's checkpoint than by so many messages, of
/// `message_bytes` in all, which it lacks. Who is wrong about it waits longer, no more.
[[nodiscard]] bool checkpoint_is_quicker(std::uint64_t messages, std::uint64_t message_bytes,
                                         std::uint64_t store_bytes);

struct StartFacts {
  std::optional<store::StoreMeta> local;  // none: the disk has no store, or one without any entry
  StreamState stream;
  /// Whether the stream's first message is there and begins with an empty state: all of it can be read.
  bool from_nothing = false;
  bool has_peers = false;
  std::uint64_t local_bytes = 0;  // of the store on the disk
  std::string rejoin{};           // why the store on the disk must not be used any more; empty: it may
  /// The stream has another message where the local store's last one was, as one answer says: what was
  /// acknowledged may be in this store alone.
  bool is_other = false;
};

struct StartPlan {
  enum class Kind : std::uint8_t {
    as_it_is,     // the store on the disk, and the stream from there on
    from_stream,  // an empty store, and all of the stream
    from_peer,    // a peer's checkpoint, and the stream from there on
    refused,      // a person has to act
  };
  Kind kind = Kind::refused;
  std::string reason;  // for the log
  bool may_do_without =
      false;  // from_peer: where no peer has a store, the other two ways lead there too, slower
};

[[nodiscard]] StartPlan plan_start(const StartFacts& facts);

/// Whether what `before` holds is in `now` too, and more: both are of one stream, of which `now` has read
/// as much at least.
[[nodiscard]] bool is_ancestor(const store::StoreMeta& before, const store::StoreMeta& now);

}  // namespace talus::server::join
