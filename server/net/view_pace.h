// How often a session's View is taken up. Ordering its chunks is the dearest thing that one message can ask
// of a thread that serves others too.
#pragma once

#include <algorithm>
#include <chrono>

namespace talus::server {

class ViewPace {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kLeastInterval{20};
  static constexpr int kIntervalPerCost = 10;  // so a tenth of the thread's time, however large the View

  /// When the next View may be taken up; the first one at any time.
  [[nodiscard]] Clock::time_point due() const { return due_; }

  /// A View was taken up from `began` on, at the cost of so much of the thread's time.
  void taken_up(Clock::time_point began, std::chrono::nanoseconds cost) {
    due_ = began + std::max<std::chrono::nanoseconds>(kLeastInterval, kIntervalPerCost * cost);
  }

 private:
  Clock::time_point due_ = Clock::time_point::min();
};

}  // namespace talus::server
