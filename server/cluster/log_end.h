// How far this server is behind the end of the log, in time: by what the stream's leader said was the end,
// and when. No clock of another server counts. Pure; of one thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace talus::server::cluster {

class LogEnd {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// Ready from within that of the end, until so far behind.
  static constexpr std::chrono::seconds kNear{1};
  static constexpr std::chrono::seconds kFar{10};
  /// Who says nothing now and then is not silent: that would hide that a server falls behind.
  static constexpr std::chrono::seconds kSilent{3};

  /// The leader, asked at `asked`, said that `last` is the last message. What it says last counts.
  void heard(std::uint64_t last, TimePoint asked);
  /// It was asked at `asked`, and said nothing.
  void unanswered(TimePoint asked);
  /// It said something, where that is the end or not: where it was silent for over kSilent, that is no time
  /// that this server is behind. Before heard().
  void answered(TimePoint asked);
  /// All up to this message is applied.
  void applied(std::uint64_t sequence);

  /// While the leader says nothing it stays what it was: a server that is cut off goes on serving.
  [[nodiscard]] bool is_ready() const { return ready_; }
  /// As of what the leader said last.
  [[nodiscard]] std::chrono::steady_clock::duration behind() const;
  /// When it was asked first without an answer, where none came since then.
  [[nodiscard]] std::optional<TimePoint> silent_since() const { return silent_since_; }
  [[nodiscard]] std::uint64_t lag() const { return last_ > applied_ ? last_ - applied_ : 0; }

 private:
  static constexpr std::size_t kMostLooks = 256;
  struct Look {
    std::uint64_t last = 0;
    TimePoint asked;
  };
  void judge();

  std::deque<Look> ahead_;  // whose `last` is not applied, by rising time
  std::optional<TimePoint> silent_since_;
  TimePoint heard_{};  // when the leader was asked last
  std::uint64_t last_ = 0;
  std::uint64_t applied_ = 0;
  bool reached_ = false;  // what was the end at some time
  bool ready_ = false;
};

}  // namespace talus::server::cluster
