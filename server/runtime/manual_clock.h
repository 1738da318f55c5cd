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
  /// The same for every thread.
  [[nodiscard]] std::chrono::nanoseconds thread_cpu() const override { return cpu_.load(); }

  /// Any thread. Timers of the operating system do not notice.
  void advance(duration by) { elapsed_ = elapsed_.load() + by; }
  /// As if work had taken so much processor time.
  void spend_cpu(std::chrono::nanoseconds time) { cpu_ = cpu_.load() + time; }

 private:
  const std::chrono::sys_seconds wall_begin_;
  // Not at 0: a time_point of 0 is what members start with.
  std::atomic<duration> elapsed_{std::chrono::hours{1}};
  std::atomic<std::chrono::nanoseconds> cpu_{};
};

}  // namespace talus::server
