#include "limits/rates/token_bucket.h"

#include <algorithm>

namespace talus::server {
namespace {

constexpr std::uint64_t kNs = 1'000'000'000;

/// Returns the whole tokens earned from the clock's zero to `now`. Seconds and their fraction are multiplied
/// apart: no product passes 63 bits within 68 years.
std::int64_t earned(const Rate& rate, TokenBucket::Time now) {
  const auto ns = static_cast<std::uint64_t>(std::chrono::nanoseconds{now.time_since_epoch()}.count());
  return static_cast<std::int64_t>(ns / kNs * rate.per_second + ns % kNs * rate.per_second / kNs);
}

/// Returns the first moment, since the clock's zero, at which `tokens` are earned.
std::chrono::nanoseconds when_earned(const Rate& rate, std::int64_t tokens) {
  const auto whole = static_cast<std::uint64_t>(std::max<std::int64_t>(0, tokens));
  const std::uint64_t rest = whole % rate.per_second * kNs;
  return std::chrono::nanoseconds{static_cast<std::int64_t>(whole / rate.per_second * kNs +
                                                            (rest + rate.per_second - 1) / rate.per_second)};
}

}  // namespace

Rate Rate::with_burst_of(std::uint64_t per_second, std::chrono::milliseconds pause) {
  const auto ms = static_cast<std::uint64_t>(pause.count());
  return {per_second, std::max<std::uint64_t>(1, per_second * ms / 1000)};
}

std::int64_t TokenBucket::level(const Rate& rate, Time now) const {
  const std::int64_t all = earned(rate, now);
  return all - std::max(gone_, all - static_cast<std::int64_t>(rate.burst));
}

bool TokenBucket::take(const Rate& rate, Time now, std::uint64_t tokens) {
  if (!rate.limited()) return true;
  if (level(rate, now) < static_cast<std::int64_t>(tokens)) return false;
  spend(rate, now, tokens);
  return true;
}

void TokenBucket::spend(const Rate& rate, Time now, std::uint64_t tokens) {
  if (!rate.limited()) return;
  gone_ = std::max(gone_, earned(rate, now) - static_cast<std::int64_t>(rate.burst)) +
          static_cast<std::int64_t>(tokens);
}

std::chrono::nanoseconds TokenBucket::wait(const Rate& rate, Time now, std::uint64_t tokens) const {
  const auto wanted = static_cast<std::int64_t>(std::min(tokens, rate.burst));
  if (!rate.limited() || level(rate, now) >= wanted) return {};
  return when_earned(rate, gone_ + wanted) - std::chrono::nanoseconds{now.time_since_epoch()};
}

std::chrono::nanoseconds TokenBucket::wait_in_line(const Rate& rate, Time now, std::uint64_t tokens) const {
  const auto wanted = static_cast<std::int64_t>(tokens);
  if (!rate.limited() || level(rate, now) >= wanted) return {};
  const std::int64_t gone = std::max(gone_, earned(rate, now) - static_cast<std::int64_t>(rate.burst));
  return when_earned(rate, gone + wanted) - std::chrono::nanoseconds{now.time_since_epoch()};
}

TokenBucket TokenBucket::moved(const Rate& from, const Rate& to, Time now) const {
  TokenBucket bucket;
  if (from.limited() && to.limited()) bucket.gone_ = earned(to, now) - level(from, now);
  return bucket;
}

}  // namespace talus::server
