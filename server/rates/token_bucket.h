// How much of something may go a second, with what was saved up before. Pure: time is passed in.
#pragma once

#include <chrono>
#include <cstdint>

namespace talus::server {

/// Tokens a second, at most 2^32 - 1, and how many are saved up while none are taken. 0 a second: no limit.
struct Rate {
  std::uint64_t per_second = 0;
  std::uint64_t burst = 0;
  [[nodiscard]] bool limited() const { return per_second != 0; }
  bool operator==(const Rate&) const = default;
};

/// Between any two moments no more goes out than burst + per_second * seconds, rounded up to a whole token,
/// but for what spend() overdraws, which is waited for afterwards. What a moment has earned is computed from
/// the clock itself, so nothing drifts however often it is asked. Begins full.
///
/// One word, so that threads may share it as std::atomic<TokenBucket>.
class TokenBucket {
 public:
  using Time = std::chrono::steady_clock::time_point;  // not before the clock's zero

  /// Takes them all, or none.
  [[nodiscard]] bool take(const Rate& rate, Time now, std::uint64_t tokens = 1);
  /// Takes them, also those that are not there.
  void spend(const Rate& rate, Time now, std::uint64_t tokens);

  /// Tokens that are there; negative where some were taken in advance. Of a Rate with a limit.
  [[nodiscard]] std::int64_t level(const Rate& rate, Time now) const;
  /// How long until so many are there, all other things equal: zero at once. No more than a burst ever are.
  [[nodiscard]] std::chrono::nanoseconds wait(const Rate& rate, Time now, std::uint64_t tokens = 1) const;

 private:
  // Of all that the rate has earned since the clock's zero, how much is gone: taken, or earned in vain when
  // the bucket was full.
  std::int64_t gone_ = INT64_MIN;
};

}  // namespace talus::server
