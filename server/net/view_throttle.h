// How often a session's View is applied. Ordering its chunks is the most expensive thing that one message can
// ask of a thread that serves other sessions too.
#pragma once

#include <algorithm>
#include <chrono>

#include "runtime/clock.h"

namespace talus::server {

class ViewThrottle {
 public:
  static constexpr std::chrono::milliseconds kMinInterval{20};
  static constexpr int kIntervalPerCost = 10;  // so a tenth of the thread's time, however large the View

  /// When the next View may be applied; the first one at any time.
  [[nodiscard]] Clock::time_point due() const { return due_; }

  /// A View was applied from `began` on, at the cost of so much of the thread's processor time.
  void applied(Clock::time_point began, std::chrono::nanoseconds cost) {
    due_ = began + std::max<std::chrono::nanoseconds>(kMinInterval, kIntervalPerCost * cost);
  }

 private:
  Clock::time_point due_ = Clock::time_point::min();
};

}  // namespace talus::server
