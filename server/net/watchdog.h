// When a session has waited long enough: for a Hello, for a whole frame, for a client that reads nothing, for
// the token's end, and for the client's end after the last frame. No I/O and no timer; times are passed in.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "runtime/clock.h"

namespace talus::server {

struct SessionTimeouts {
  std::chrono::milliseconds handshake{};  // from the connection's beginning to a whole Hello
  std::chrono::milliseconds idle{};       // from one whole frame to the next
  std::chrono::milliseconds write{};      // without a byte taken, while a write is in flight
};

class Watchdog {
 public:
  /// To write the last frames and to read the client's end.
  static constexpr std::chrono::milliseconds kTimeToClose{2000};

  /// `timeouts` outlive it.
  Watchdog(const SessionTimeouts& timeouts, Clock::time_point opened)
      : timeouts_{timeouts}, opened_{opened}, last_frame_{opened} {}

  void frame_came(Clock::time_point now) { last_frame_ = now; }
  void greeted() { greeted_ = true; }
  void token_ends(Clock::time_point at) { token_ends_ = at; }
  /// While the server reads nothing a client cannot be idle.
  void reading_pauses() { reading_paused_ = true; }
  void reading_resumes(Clock::time_point now) {
    reading_paused_ = false;
    last_frame_ = now;
  }
  /// A write begins, or some of it was taken.
  void writing(Clock::time_point now) { write_progress_ = now; }
  void written() { write_progress_.reset(); }
  /// From here on only the close is waited for. True the first time.
  bool closes(Clock::time_point now);

  enum class Verdict : std::uint8_t {
    wait,           // until next()
    closed,         // kTimeToClose is over
    write_stalled,  // for timeouts.write
    token_expired,
    silent,  // no Hello within timeouts.handshake, or no frame within timeouts.idle
  };
  [[nodiscard]] Verdict check(Clock::time_point now) const;
  /// When to check again, if nothing happens.
  [[nodiscard]] Clock::time_point next(Clock::time_point now) const;

 private:
  [[nodiscard]] Clock::time_point silence_ends(Clock::time_point now) const;

  const SessionTimeouts& timeouts_;
  Clock::time_point opened_;
  Clock::time_point last_frame_;
  std::optional<Clock::time_point> token_ends_;
  std::optional<Clock::time_point> write_progress_;  // while a write is in flight
  std::optional<Clock::time_point> closing_since_;
  bool greeted_ = false;
  bool reading_paused_ = false;
};

/// From `now` to the end of a session whose token expires at `expires`: clocks may differ by kClockSkew. At
/// most a century: timers cannot count as far as tokens can.
[[nodiscard]] std::chrono::nanoseconds token_lifetime(std::chrono::sys_seconds expires,
                                                      std::chrono::sys_seconds now);

}  // namespace talus::server
