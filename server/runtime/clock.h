// The time, as every module of the server asks for it. Tests pass a ManualClock.
#pragma once

#include <chrono>

namespace talus::server {

/// Callable from any thread. Never copied: pass a reference; it outlives who holds it.
class Clock {
 public:
  using duration = std::chrono::steady_clock::duration;
  using time_point = std::chrono::steady_clock::time_point;

  virtual ~Clock() = default;

  /// Monotonic: for deadlines, rates and latencies.
  [[nodiscard]] virtual time_point now() const = 0;
  /// The calendar's time, UTC: for tokens and certificates alone.
  [[nodiscard]] virtual std::chrono::sys_seconds wall() const = 0;
  /// Processor time that the calling thread has used: for the cost of work.
  [[nodiscard]] virtual std::chrono::nanoseconds thread_cpu() const = 0;
};

/// The machine's own.
class SystemClock final : public Clock {
 public:
  [[nodiscard]] time_point now() const override;
  [[nodiscard]] std::chrono::sys_seconds wall() const override;
  [[nodiscard]] std::chrono::nanoseconds thread_cpu() const override;
};

}  // namespace talus::server
