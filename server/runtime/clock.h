// The time source of every module of the server. Tests pass a ManualClock.
#pragma once

#include <chrono>

namespace talus::server {

/// Callable from any thread. Never copied: pass a reference to a clock that outlives its users.
class Clock {
 public:
  using duration = std::chrono::steady_clock::duration;
  using time_point = std::chrono::steady_clock::time_point;

  virtual ~Clock() = default;

  /// Monotonic: for deadlines, rates and latencies.
  [[nodiscard]] virtual time_point now() const = 0;
  /// now() plus the time for which the machine was suspended, if the system counts it.
  [[nodiscard]] virtual time_point uptime() const { return now(); }
  /// Calendar time in UTC, used only for tokens, certificates and the dates of edits.
  [[nodiscard]] virtual std::chrono::sys_seconds wall() const = 0;
  /// Processor time used by the calling thread, for measuring the cost of work.
  [[nodiscard]] virtual std::chrono::nanoseconds thread_cpu() const = 0;
};

/// The system's clocks.
class SystemClock final : public Clock {
 public:
  [[nodiscard]] time_point now() const override;
  [[nodiscard]] time_point uptime() const override;
  [[nodiscard]] std::chrono::sys_seconds wall() const override;
  [[nodiscard]] std::chrono::nanoseconds thread_cpu() const override;
};

}  // namespace talus::server
