// How often a server publishes. A message costs NATS and all servers more than an edit does: under load,
// messages that follow each other at once take the processors that their acknowledgements wait for. Pure.
#pragma once

#include <chrono>
#include <cstddef>

namespace talus::server::cluster {

/// Between the beginnings of two messages with more than kFewEntries together.
constexpr std::chrono::milliseconds kMessagePace{3};
constexpr std::size_t kFewEntries = 4;

struct SentMessage {
  std::chrono::steady_clock::time_point at;
  std::size_t entries = 0;
};

/// When the next message, for which so many entries wait, is sent at the soonest.
[[nodiscard]] constexpr std::chrono::steady_clock::time_point next_message_at(const SentMessage& last,
                                                                              std::size_t waiting) {
  return last.entries + waiting > kFewEntries ? last.at + kMessagePace : last.at;
}

}  // namespace talus::server::cluster
