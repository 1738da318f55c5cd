#include "net/watchdog.h"

#include <algorithm>

#include "config/access/signed_token.h"

namespace talus::server {

bool Watchdog::closes(Clock::time_point now) {
  if (closing_since_) return false;
  closing_since_ = now;
  return true;
}

Watchdog::Verdict Watchdog::check(Clock::time_point now) const {
  if (closing_since_ && now >= *closing_since_ + kTimeToClose) return Verdict::closed;
  if (write_progress_ && now >= *write_progress_ + timeouts_.write) return Verdict::write_stalled;
  if (closing_since_) return Verdict::wait;
  if (token_ends_ && now >= *token_ends_) return Verdict::token_expired;
  return now >= silence_ends(now) ? Verdict::silent : Verdict::wait;
}

Clock::time_point Watchdog::next(Clock::time_point now) const {
  // If no write is in flight, one may begin before the next check.
  const auto stalls = write_progress_.value_or(now) + timeouts_.write;
  if (closing_since_) return std::min(*closing_since_ + kTimeToClose, stalls);
  const auto silence = silence_ends(now);
  return std::min({silence, token_ends_.value_or(silence), stalls});
}

Clock::time_point Watchdog::silence_ends(Clock::time_point now) const {
  if (!greeted_) return opened_ + timeouts_.handshake;
  return (expects_no_more_ ? now : last_frame_) + timeouts_.idle;
}

std::chrono::nanoseconds token_lifetime(std::chrono::sys_seconds expires, std::chrono::sys_seconds now) {
  constexpr std::chrono::seconds kCentury{std::int64_t{36'525} * 86'400};
  return std::clamp(expires - now, -kClockSkew, kCentury) + kClockSkew;
}

}  // namespace talus::server
