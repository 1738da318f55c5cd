// Paces a server's messages. A message costs NATS and all servers more than an edit does: under load,
// messages sent back to back take the processor time that their acknowledgements need. So the next message
// waits for a multiple of the recent acknowledgement time: on idle processors acknowledgements are fast and
// edits wait briefly; on busy ones messages become rarer. Pure.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace talus::server::cluster {

class MessagePace {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  using Duration = std::chrono::steady_clock::duration;

  /// Maximum interval between two messages with more than kFewEntries together.
  static constexpr Duration kLongest = std::chrono::milliseconds{3};
  /// The interval is this multiple of the acknowledgement time, if that is less.
  static constexpr int kAcknowledgements = 4;
  static constexpr std::size_t kFewEntries = 4;

  void sent(TimePoint at, std::size_t entries) {
    sent_at_ = at;
    entries_ = entries;
  }
  /// The last message was acknowledged after `took`. Smoothed like TCP's round-trip times; an outlier counts
  /// as no more than the time that leads to kLongest.
  void acknowledged(Duration took) { took_ += (std::min(took, kLongest / kAcknowledgements) - took_) / 8; }

  [[nodiscard]] Duration now() const { return kAcknowledgements * took_; }
  /// Earliest time for the next message, with `waiting` queued entries.
  [[nodiscard]] TimePoint next_at(std::size_t waiting) const {
    return entries_ + waiting > kFewEntries ? sent_at_ + now() : sent_at_;
  }

 private:
  TimePoint sent_at_;
  std::size_t entries_ = 0;
  Duration took_ = kLongest / kAcknowledgements;
};

}  // namespace talus::server::cluster
