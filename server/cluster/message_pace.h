// How often a server publishes. A message costs NATS and all servers more than an edit does: under load,
// messages that follow each other at once take the processors that their acknowledgements wait for. So the
// next message waits for some times as long as an acknowledgement takes of late: where processors are idle
// acknowledgements are quick, and edits wait little; where they are not, messages become fewer. Pure.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace talus::server::cluster {

class MessagePace {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  using Duration = std::chrono::steady_clock::duration;

  /// Between the beginnings of two messages with more than kFewEntries together, at most.
  static constexpr Duration kLongest = std::chrono::milliseconds{3};
  /// So many times as long as an acknowledgement takes lies between them, where that is less.
  static constexpr int kAcknowledgements = 4;
  static constexpr std::size_t kFewEntries = 4;

  void sent(TimePoint at, std::size_t entries) {
    sent_at_ = at;
    entries_ = entries;
  }
  /// The message sent last was acknowledged after so long. A time is smoothed as TCP smooths that of its
  /// round trips, and one that was stuck counts as no more than it takes to reach kLongest.
  void acknowledged(Duration took) { took_ += (std::min(took, kLongest / kAcknowledgements) - took_) / 8; }

  [[nodiscard]] Duration now() const { return kAcknowledgements * took_; }
  /// When the next message, for which so many entries wait, is sent at the soonest.
  [[nodiscard]] TimePoint next_at(std::size_t waiting) const {
    return entries_ + waiting > kFewEntries ? sent_at_ + now() : sent_at_;
  }

 private:
  TimePoint sent_at_;
  std::size_t entries_ = 0;
  Duration took_ = kLongest / kAcknowledgements;
};

}  // namespace talus::server::cluster
