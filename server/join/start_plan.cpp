#include "join/start_plan.h"

#include <fmt/format.h>

namespace talus::server::join {
namespace {

using Kind = StartPlan::Kind;

StartPlan plan_without_store(const StartFacts& facts) {
  const StreamState& stream = facts.stream;
  if (stream.last == 0) {
    return {
        Kind::refused,
        "the cluster's stream is empty; \"talusd cluster init\" begins one for a new store, \"talusd store "
        "join-cluster\" for a store that is there"};
  }
  if (!facts.from_nothing) {
    return {Kind::from_peer, "there is no store here, and the stream does not go back to an empty one"};
  }
  if (facts.has_peers && stream.last > kFarMessages) {
    return {Kind::from_peer,
            fmt::format("there is no store here, and the stream has {} messages", stream.last), true};
  }
  return {Kind::from_stream,
          fmt::format("there is no store here; the stream has all of it, {} messages", stream.last)};
}

/// Another stream than that of which the store is.
std::string other_stream(std::string_view what) {
  return fmt::format(
      "{}; where the stream was lost for good, run \"talusd store fork\" on the server that is furthest, and "
      "let the "
      "others join it",
      what);
}

}  // namespace

StartPlan plan_start(const StartFacts& facts) {
  if (!facts.local) return plan_without_store(facts);
  const StreamPlace& place = facts.local->stream;
  const StreamState& stream = facts.stream;
  if (place.sequence == 0) {
    return {
        Kind::refused,
        fmt::format(
            "the store here, at revision {}, is in no cluster; \"talusd store join-cluster\" takes it into "
            "one, or give --data an empty directory",
            facts.local->head.revision)};
  }
  if (place.created_ns != stream.created_ns) {
    return {Kind::refused,
            other_stream("the stream is not the one that this store has read so far: it was made anew")};
  }
  if (place.sequence > stream.last) {
    return {Kind::refused,
            other_stream(fmt::format(
                "the stream ends at message {}, and this store has read {}: the stream lost its end",
                stream.last, place.sequence))};
  }
  if (!facts.rejoin.empty()) return {Kind::from_peer, facts.rejoin};
  if (place.sequence + 1 < stream.first) {
    return {Kind::from_peer,
            fmt::format("this store has read up to message {}, and the stream begins with {}", place.sequence,
                        stream.first)};
  }
  if (const std::uint64_t behind = stream.last - place.sequence; facts.has_peers && behind > kFarMessages) {
    return {Kind::from_peer, fmt::format("this store is {} messages behind", behind), true};
  }
  return {Kind::as_it_is, fmt::format("{} messages behind", stream.last - place.sequence)};
}

bool is_ancestor(const StoreMeta& before, const StoreMeta& now) {
  return before.stream.sequence > 0 && before.store_id == now.store_id &&
         before.stream.created_ns == now.stream.created_ns && before.stream.sequence <= now.stream.sequence;
}

}  // namespace talus::server::join
