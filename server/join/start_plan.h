// What a server of a cluster does with the store that it finds on its disk, before it serves. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cluster/log_stream.h"
#include "store/records.h"

namespace talus::server::join {

/// So many messages are read from the stream in about the time that a peer's checkpoint takes; more are not
/// worth it where there is a peer.
inline constexpr std::uint64_t kFarMessages = 100'000;

struct StartFacts {
  std::optional<StoreMeta> local;  // none: the disk has no store, or one without any entry
  StreamState stream;
  /// Whether the stream's first message is there and begins with an empty state: all of it can be read.
  bool from_nothing = false;
  bool has_peers = false;
  std::string rejoin{};  // why the store on the disk must not be used any more; empty: it may
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
[[nodiscard]] bool is_ancestor(const StoreMeta& before, const StoreMeta& now);

}  // namespace talus::server::join
