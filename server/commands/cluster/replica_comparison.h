// Compares the messages held by the replicas of a stream. NATS calls a replica "current" by position only: a
// nats-server that took a message twice, or lost one, stays "current".
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cluster/jetstream/stream_info.h"
#include "cluster/jetstream/stream_names.h"

namespace talus::server::cluster_tool {

/// Reply of some replica to a Direct Get; NATS chooses the replica and does not name it.
struct ReplicaAnswer {
  std::uint64_t sequence = 0;  // 0: the replica lacks the message
  std::string text;
};

/// Queries used by compare_replicas().
struct ReplicaQuestions {
  /// An error is one line: there was no answer.
  std::function<tl::expected<ReplicaAnswer, std::string>(const std::string& question)> ask;
  /// Current information from the leader; nullopt if it does not answer.
  std::function<std::optional<jetstream::StreamInfo>()> info;
  /// Waits briefly for a lagging replica.
  std::function<void()> pause;
};

/// Requests the stream's end and a few earlier messages, often enough that each replica answers. An extra or
/// a lost message shifts all later ones, so these few suffice. Returns a line per difference; an error is why
/// replicas could not be compared. Sends about 150 requests, with at most 20 pauses per request.
[[nodiscard]] tl::expected<std::vector<std::string>, std::string> compare_replicas(
    const ReplicaQuestions& questions, const jetstream::StreamNames& names);

}  // namespace talus::server::cluster_tool
