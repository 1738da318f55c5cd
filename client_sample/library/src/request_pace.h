// Decides when a client may send its next request: within the server's advertised rate, and not before a
// retry time that the server gave. Pure: the caller passes the time.
#pragma once

#include <cstdint>

#include <talus/client/clock.h>
#include <talus/client/world_info.h>

namespace talus::client {

/// A token bucket of 7/8 of the server's burst: the rest allows for requests that the network delays and then
/// delivers together. Initially full, like the server's.
class RequestPace {
 public:
  using Time = Clock::Time;

  /// Unlimited, except by refused().
  RequestPace() = default;
  /// Uses the lower of the session's and the address's rate.
  RequestPace(const ServerLimits& limits, Time now);

  /// Returns true and counts a request if one may be sent.
  [[nodiscard]] bool take(Time now);
  /// Counts a request that is sent regardless.
  void spend(Time now);
  /// The server refused a request and will have room for all refused ones after `retry_after`. No request is
  /// granted until then; afterwards the refused ones are granted at the normal rate.
  void refused(Time now, std::chrono::milliseconds retry_after);

  /// Time at which take() grants the next request; at most `now` if it may go at once.
  [[nodiscard]] Time next(Time now) const;

 private:
  [[nodiscard]] bool limited() const { return per_second_ != 0; }
  [[nodiscard]] double level(Time now) const;

  std::uint64_t per_second_ = 0;  // 0: unlimited
  double max_level_ = 0;
  double level_ = 0;  // at updated_; negative when overdrawn
  Time updated_{};    // may lie in the future, while held
  Time held_until_{};
  double refused_ = 0;  // refused since the server last granted a request
};

}  // namespace talus::client
