// Times out a session that waits too long: for a Hello, a whole frame, a client that reads nothing, the
// token's end, or the client's end after the last frame. No I/O or timers; times are passed in.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "runtime/clock.h"

namespace talus::server {

struct SessionTimeouts {
  std::chrono::milliseconds handshake{};  // from the connection's beginning to a whole Hello
  std::chrono::milliseconds idle{};       // from one whole frame to the next
  std::chrono::milliseconds write{};      // without progress while a write is in flight
};

class Watchdog {
 public:
  /// Time to write the last frames and to read the client's end.
  static constexpr std::chrono::milliseconds kTimeToClose{2000};

  /// `timeouts` outlive it.
  Watchdog(const SessionTimeouts& timeouts, Clock::time_point opened)
      : timeouts_{timeouts}, opened_{opened}, last_frame_{opened} {}

  void frame_came(Clock::time_point now) { last_frame_ = now; }
  void greeted() { greeted_ = true; }
  void token_ends(Clock::time_point at) { token_ends_ = at; }
  /// The client has promised to send no more.
  void expects_no_more() { expects_no_more_ = true; }
  /// A write begins or has made progress.
  void writing(Clock::time_point now) { write_progress_ = now; }
  void written() { write_progress_.reset(); }
  /// From here on only kTimeToClose applies. Returns true the first time.
  bool closes(Clock::time_point now);

  enum class Verdict : std::uint8_t {
    wait,           // until next()
    closed,         // kTimeToClose has passed
    write_stalled,  // no progress for timeouts.write
    token_expired,
    silent,  // no Hello within timeouts.handshake, or no frame within timeouts.idle
  };
  [[nodiscard]] Verdict check(Clock::time_point now) const;
  /// Time of the next check if nothing happens.
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
  bool expects_no_more_ = false;
};

/// Time from `now` to the end of a session whose token expires at `expires`, allowing for a clock difference
/// of kClockSkew. At most a century: timers have a smaller range than tokens.
[[nodiscard]] std::chrono::nanoseconds token_lifetime(std::chrono::sys_seconds expires,
                                                      std::chrono::sys_seconds now);

}  // namespace talus::server
