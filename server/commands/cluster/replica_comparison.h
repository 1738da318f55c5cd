// Whether the replicas of a stream hold the same messages. NATS calls replicas current that are as far as
// their leader, whatever they hold: a nats-server that took a message twice, or lost one, stays "current".
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

/// What some replica says to a Direct Get: which one does is NATS' choice, and it does not say.
struct ReplicaAnswer {
  std::uint64_t sequence = 0;  // 0: it has no such message
  std::string text;
};

/// Whom compare_replicas() asks.
struct ReplicaQuestions {
  /// An error, in one line: no answer came.
  std::function<tl::expected<ReplicaAnswer, std::string>(const std::string& question)> ask;
  /// What the leader says now; nothing where it says nothing.
  std::function<std::optional<jetstream::StreamInfo>()> info;
  /// Waits a little, for a replica that lags behind.
  std::function<void()> pause;
};

/// Asks for the stream's end and for some messages before it, so often that each replica answers. A message
/// too many or too few shifts all later ones, so these few say it. A line for each difference; an error is
/// why they were not compared. About 150 questions, and 20 pauses for a question at most.
[[nodiscard]] tl::expected<std::vector<std::string>, std::string> compare_replicas(
    const ReplicaQuestions& questions, const jetstream::StreamNames& names);

}  // namespace talus::server::cluster_tool
