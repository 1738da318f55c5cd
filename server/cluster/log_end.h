// Measures in time how far this server lags behind the end of the log, from the ends that the leader reported
// and when. Uses no other server's clock. Pure; for one thread.
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

  /// Becomes ready within kNear of the end, and stays ready until kFar behind.
  static constexpr std::chrono::seconds kNear{1};
  static constexpr std::chrono::seconds kFar{10};
  /// Occasional missing answers do not count as silence, which would hide that a server falls behind.
  static constexpr std::chrono::seconds kSilent{3};

  /// The leader, asked at `asked`, reported `last` as the end. Later reports override earlier ones.
  void heard(std::uint64_t last, TimePoint asked);
  /// The leader, asked at `asked`, did not answer.
  void unanswered(TimePoint asked);
  /// The leader answered, whether or not with the end. A silence longer than kSilent does not count as lag.
  /// Call before heard().
  void answered(TimePoint asked);
  /// All messages up to this one are applied.
  void applied(std::uint64_t sequence);

  /// Unchanged while the leader is silent: a server that is cut off continues to serve.
  [[nodiscard]] bool is_ready() const { return ready_; }
  /// As of the leader's last report.
  [[nodiscard]] std::chrono::steady_clock::duration behind() const;
  /// Time of the first request without an answer since the last answer; nullopt if answered.
  [[nodiscard]] std::optional<TimePoint> silent_since() const { return silent_since_; }
  [[nodiscard]] std::uint64_t lag() const { return last_ > applied_ ? last_ - applied_ : 0; }

 private:
  static constexpr std::size_t kMaxReports = 256;
  struct Report {
    std::uint64_t last = 0;
    TimePoint asked;
  };
  void judge();

  std::deque<Report> ahead_;  // reports whose `last` is not applied yet, by ascending time
  std::optional<TimePoint> silent_since_;
  TimePoint heard_{};  // when the leader was last asked
  std::uint64_t last_ = 0;
  std::uint64_t applied_ = 0;
  bool reached_ = false;  // a past end
  bool ready_ = false;
};

}  // namespace talus::server::cluster
