// When a client may send its next request: within the rate that the server told, and not before a time at
// which the server asked it to come back. Pure: the caller passes the time.
#pragma once

#include <cstdint>

#include <talus/client/clock.h>
#include <talus/client/world_info.h>

namespace talus::client {

/// A token bucket of 7/8 of the server's burst: the rest allows for requests that the network delays and then
/// delivers together. Full at first, as the server's.
class RequestPace {
 public:
  using Time = Clock::Time;

  /// No limit, but for what refused() says.
  RequestPace() = default;
  /// The lower one of the rates of the session and of its address.
  RequestPace(const ServerLimits& limits, Time now);

  /// One request may go, and counts as sent.
  [[nodiscard]] bool take(Time now);
  /// Counts one that goes all the same.
  void spend(Time now);
  /// The server refused a request, and has room for all that it refused after `retry_after`. None goes until
  /// then, and then as many as were refused, at the rate.
  void refused(Time now, std::chrono::milliseconds retry_after);

  /// When take() grants the next one; `now` or earlier: at once.
  [[nodiscard]] Time next(Time now) const;

 private:
  [[nodiscard]] bool limited() const { return per_second_ != 0; }
  [[nodiscard]] double level(Time now) const;

  std::uint64_t per_second_ = 0;  // 0: no limit
  double most_ = 0;
  double level_ = 0;  // at updated_; negative when overdrawn
  Time updated_{};    // may lie ahead, while held
  Time held_until_{};
  double refused_ = 0;  // since the server last granted something
};

}  // namespace talus::client
