// A token bucket: limits how many tokens may go a second, and how many at once after a pause. The one rate
// limiter of the server. Pure: the caller passes the time.
#pragma once

#include <chrono>
#include <cstdint>

namespace talus::server {

/// `per_second` tokens are earned a second, at most 2^32 - 1; at most `burst` are kept. 0 a second: no limit.
struct Rate {
  std::uint64_t per_second = 0;
  std::uint64_t burst = 0;

  /// The burst is what the rate earns in `pause`, at least 1 token.
  [[nodiscard]] static Rate with_burst_of(std::uint64_t per_second, std::chrono::milliseconds pause);

  [[nodiscard]] bool limited() const { return per_second != 0; }
  bool operator==(const Rate&) const = default;
};

/// Invariant: between any two moments take() grants at most burst + per_second * seconds, rounded up to a
/// whole token. spend() may overdraw; later calls wait until the debt is paid. The state is an absolute
/// count, so rounding never accumulates. A new bucket is full.
///
/// The state is one word: threads may share a bucket as std::atomic<TokenBucket>. Every call on one bucket
/// must pass the same Rate; if that changes, moved() returns a bucket for the new one.
class TokenBucket {
 public:
  using Time = std::chrono::steady_clock::time_point;  // not before the clock's zero

  /// Takes all `tokens` and returns true, or takes none and returns false.
  [[nodiscard]] bool take(const Rate& rate, Time now, std::uint64_t tokens = 1);
  /// Takes `tokens` even if the bucket has fewer.
  void spend(const Rate& rate, Time now, std::uint64_t tokens);
  /// Takes back tokens that were taken or spent before, and not used. Tokens beyond a burst are lost.
  void give_back(std::uint64_t tokens) { gone_ -= static_cast<std::int64_t>(tokens); }

  /// Returns the tokens in the bucket; negative when overdrawn. `rate` must have a limit.
  [[nodiscard]] std::int64_t level(const Rate& rate, Time now) const;
  /// Returns how long until the bucket has `tokens`, if no caller takes any meanwhile; 0: it has them now. A
  /// bucket never has more than a burst, so a wait for more than a burst is a wait for a burst.
  [[nodiscard]] std::chrono::nanoseconds wait(const Rate& rate, Time now, std::uint64_t tokens = 1) const;
  /// Returns how long until `tokens` have been earned from now on, in addition to what pays a debt: the wait
  /// of the last of `tokens` callers who each take a token when it is there. Unlike wait() it is not bounded
  /// by the burst.
  [[nodiscard]] std::chrono::nanoseconds wait_in_line(const Rate& rate, Time now, std::uint64_t tokens) const;

  /// Returns a bucket of the rate `to` with the tokens, or the debt, that this one has of the rate `from`,
  /// and not more than its burst; full if one of them has no limit.
  [[nodiscard]] TokenBucket moved(const Rate& from, const Rate& to, Time now) const;

 private:
  // Number of tokens earned since the clock's zero that are gone: taken, or lost because the bucket was full.
  std::int64_t gone_ = INT64_MIN;
};

}  // namespace talus::server
