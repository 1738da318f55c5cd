#include "cluster/join/start_plan.h"

#include <fmt/format.h>

namespace talus::server::join {
namespace {

using Kind = StartPlan::Kind;

// Measured on two cores that all servers shared: applying a message, the edits in it by size, and downloading
// a checkpoint while the peer sends two at the default of rates.checkpoint_bytes.
constexpr double kMessageSeconds = 150e-6;
constexpr double kAppliedBytesPerSecond = 10 << 20;
constexpr double kCheckpointSeconds = 1;
constexpr double kTakenBytesPerSecond = 32 << 20;

/// Estimated size of messages, from the mean of those that the stream keeps.
std::uint64_t bytes_of(std::uint64_t messages, const StreamState& stream) {
  const double kept = static_cast<double>(stream.last) - static_cast<double>(stream.first) + 1;
  if (kept < 1) return 0;
  return static_cast<std::uint64_t>(static_cast<double>(stream.bytes) * static_cast<double>(messages) / kept);
}

StartPlan plan_without_store(const StartFacts& facts) {
  const StreamState& stream = facts.stream;
  if (stream.last == 0) {
    return {Kind::refused,
            "the cluster's stream is empty; \"talusd cluster init\" begins one for a new store, \"talusd "
            "store join-cluster\" for an existing store"};
  }
  if (!facts.from_nothing) {
    return {Kind::from_peer, "this server has no store, and the stream does not go back to an empty one"};
  }
  // A store made from the messages is hardly larger than they are.
  if (facts.has_peers && checkpoint_is_quicker(stream.last, stream.bytes, stream.bytes)) {
    return {Kind::from_peer,
            fmt::format("this server has no store, and the stream has {} messages", stream.last), true};
  }
  return {Kind::from_stream,
          fmt::format("this server has no store; the stream has all of it, {} messages", stream.last)};
}

/// Error text for a stream that is not the store's.
std::string other_stream(std::string_view what) {
  return fmt::format(
      "{}; if the stream was lost for good, run \"talusd store fork\" on the server that is furthest, and "
      "let the others join it",
      what);
}

}  // namespace

StartPlan plan_start(const StartFacts& facts) {
  if (!facts.local) return plan_without_store(facts);
  const store::StreamPlace& place = facts.local->stream;
  const StreamState& stream = facts.stream;
  if (place.sequence == 0) {
    return {Kind::refused, fmt::format("the store here, at revision {}, is not in a cluster; \"talusd store "
                                       "join-cluster\" takes it into one, or give --data an empty directory",
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
  if (facts.is_other) {
    return {Kind::as_it_is,
            fmt::format("the store seems to be of another stream: message {} differs there", place.sequence)};
  }
  const std::uint64_t behind = stream.last - place.sequence;
  const std::uint64_t bytes = bytes_of(behind, stream);
  if (facts.has_peers && checkpoint_is_quicker(behind, bytes, facts.local_bytes + bytes)) {
    return {Kind::from_peer, fmt::format("this store is {} messages behind", behind), true};
  }
  return {Kind::as_it_is, fmt::format("{} messages behind", behind)};
}

bool checkpoint_is_quicker(std::uint64_t messages, std::uint64_t message_bytes, std::uint64_t store_bytes) {
  const double by_messages = static_cast<double>(messages) * kMessageSeconds +
                             static_cast<double>(message_bytes) / kAppliedBytesPerSecond;
  return by_messages > kCheckpointSeconds + static_cast<double>(store_bytes) / kTakenBytesPerSecond;
}

bool is_ancestor(const store::StoreMeta& before, const store::StoreMeta& now) {
  return before.stream.sequence > 0 && before.store_id == now.store_id &&
         before.stream.created_ns == now.stream.created_ns && before.stream.sequence <= now.stream.sequence;
}

}  // namespace talus::server::join
