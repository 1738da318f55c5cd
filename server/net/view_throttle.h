// Limits the rate at which a session's Views are applied. Ordering a View's chunks is the most expensive
// request that one message can make of a thread that also serves other sessions.
#pragma once

#include <algorithm>
#include <chrono>

#include "runtime/clock.h"

namespace talus::server {

class ViewThrottle {
 public:
  static constexpr std::chrono::milliseconds kMinInterval{20};
  static constexpr int kIntervalPerCost = 10;  // a tenth of the thread's time, however large the View

  /// Earliest time of the next View; the first may come at any time.
  [[nodiscard]] Clock::time_point due() const { return due_; }

  /// A View was applied, starting at `began`, for `cost` of the thread's processor time.
  void applied(Clock::time_point began, std::chrono::nanoseconds cost) {
    due_ = began + std::max<std::chrono::nanoseconds>(kMinInterval, kIntervalPerCost * cost);
  }

 private:
  Clock::time_point due_ = Clock::time_point::min();
};

}  // namespace talus::server
