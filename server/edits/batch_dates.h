// Dates the batches of a log that only one server writes.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "runtime/clock.h"

namespace talus::server {

/// Follows the wall clock, but a jump ahead of over kMaxJump counts only after kPatience. Dates never
/// decrease, unless the last date is over kMaxJump ahead of the wall clock for kPatience: then the clock was
/// wrong at that date. For one thread.
class BatchDates {
 public:
  static constexpr std::chrono::minutes kMaxJump{1};
  static constexpr std::chrono::minutes kPatience{10};

  /// `clock` outlives this. Its wall clock is believed now.
  explicit BatchDates(const Clock& clock) : clock_{clock}, believed_{clock.wall()}, at_{clock.uptime()} {}

  /// Reads the clock, in milliseconds since 1970.
  [[nodiscard]] std::int64_t now_ms();
  /// Returns the date of a batch that follows one dated `last_ms`. Call it at least every few seconds, so
  /// that a slow change is not a jump.
  [[nodiscard]] std::int64_t after(std::int64_t last_ms);

  struct Jumps {
    std::uint64_t count = 0;
    std::chrono::seconds last{};  // negative: the clock was that far behind the last date
  };
  [[nodiscard]] const Jumps& jumps() const { return jumps_; }

 private:
  const Clock& clock_;
  std::chrono::sys_seconds believed_;  // the wall clock at `at_`
  Clock::time_point at_;
  std::optional<Clock::time_point> jumped_at_;
  std::optional<Clock::time_point> behind_at_;  // since then the wall clock is behind the last date
  Jumps jumps_;
};

}  // namespace talus::server
