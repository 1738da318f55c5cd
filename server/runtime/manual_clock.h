// A clock that stands still until a test moves it (after Seastar's manual_clock).
#pragma once

#include <atomic>

#include "runtime/clock.h"

namespace talus::server {

class ManualClock final : public Clock {
 public:
  explicit ManualClock(std::chrono::sys_seconds wall = std::chrono::sys_seconds{}) : wall_begin_{wall} {}

  [[nodiscard]] time_point now() const override { return time_point{} + elapsed_.load(); }
  [[nodiscard]] std::chrono::sys_seconds wall() const override {
    return wall_begin_ + std::chrono::floor<std::chrono::seconds>(elapsed_.load());
  }
  /// The same value for every thread.
  [[nodiscard]] std::chrono::nanoseconds thread_cpu() const override { return cpu_.load(); }

  /// Callable from any thread. Does not fire operating-system timers.
  void advance(duration by) { elapsed_ = elapsed_.load() + by; }
  /// Adds `time` to the processor time used.
  void spend_cpu(std::chrono::nanoseconds time) { cpu_ = cpu_.load() + time; }

 private:
  const std::chrono::sys_seconds wall_begin_;
  // Not 0, because members initialise time_points to 0.
  std::atomic<duration> elapsed_{std::chrono::hours{1}};
  std::atomic<std::chrono::nanoseconds> cpu_{};
};

}  // namespace talus::server
