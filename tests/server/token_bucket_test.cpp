#include "limits/rates/token_bucket.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include <rapidcheck.h>

using namespace talus::server;
using std::chrono::nanoseconds;

namespace {

using Time = TokenBucket::Time;

Time at(std::int64_t ns) {
  return Time{nanoseconds{ns}};
}

/// What a rate earns in `ns`, rounded up; by 128 bits, so that nothing is rounded on the way.
std::int64_t earned_at_most(const Rate& rate, std::int64_t ns) {
  __extension__ using Wide = unsigned __int128;
  return static_cast<std::int64_t>((Wide{rate.per_second} * static_cast<std::uint64_t>(ns) + 999'999'999) /
                                   1'000'000'000);
}

Rate any_rate() {
  const auto per_second =
      *rc::gen::oneOf(rc::gen::inRange<std::uint64_t>(1, 10), rc::gen::inRange<std::uint64_t>(1, 1'000'000),
                      rc::gen::inRange<std::uint64_t>(1, 0xFFFF'FFFF));
  return {per_second, *rc::gen::inRange<std::uint64_t>(1, 4 * per_second + 1)};
}

/// Up to 68 years after the clock's zero, so long as counts of the greatest rate have place.
std::int64_t any_start() {
  constexpr std::int64_t kYear = std::int64_t{31'557'600} * 1'000'000'000;
  return *rc::gen::inRange<std::int64_t>(0, 68 * kYear);
}

}  // namespace

TEST_CASE("in no stretch of time more is taken than the burst and what the rate earns in it") {
  CHECK(rc::check([] {
    const Rate rate = any_rate();
    TokenBucket bucket;
    std::int64_t now = any_start();
    std::vector<std::pair<std::int64_t, std::int64_t>> taken;
    using Step = std::pair<std::uint64_t, std::int64_t>;  // tokens, and nanoseconds after them
    const auto steps = *rc::gen::container<std::vector<Step>>(
        rc::gen::pair(rc::gen::inRange<std::uint64_t>(0, rate.burst + 1),
                      rc::gen::inRange<std::int64_t>(0, 3'000'000'000)));
    for (const auto& [tokens, pause] : steps) {
      if (bucket.take(rate, at(now), tokens)) taken.emplace_back(now, static_cast<std::int64_t>(tokens));
      now += pause;
    }
    for (std::size_t first = 0; first < taken.size(); ++first) {
      std::int64_t sum = 0;
      for (std::size_t last = first; last < taken.size(); ++last) {
        sum += taken[last].second;
        const std::int64_t ns = taken[last].first - taken[first].first;
        RC_ASSERT(sum <= static_cast<std::int64_t>(rate.burst) + earned_at_most(rate, ns));
      }
    }
  }));
}

TEST_CASE("after the wait there is room, and not a nanosecond before") {
  CHECK(rc::check([] {
    const Rate rate = any_rate();
    TokenBucket bucket;
    const std::int64_t now = any_start();
    bucket.spend(rate, at(now), *rc::gen::inRange<std::uint64_t>(0, 3 * rate.burst + 1));
    const auto tokens = *rc::gen::inRange<std::uint64_t>(1, rate.burst + 1);
    const std::int64_t wait = bucket.wait(rate, at(now), tokens).count();
    RC_ASSERT(wait >= 0);
    TokenBucket early = bucket;
    if (wait > 0) RC_ASSERT_FALSE(early.take(rate, at(now + wait - 1), tokens));
    RC_ASSERT(bucket.take(rate, at(now + wait), tokens));
  }));
}

// The clock counts nanoseconds: of a higher rate each of them brings several tokens.
TEST_CASE("a bucket that is always emptied at once gives its rate for ever, to the token") {
  CHECK(rc::check([] {
    Rate rate = any_rate();
    rate.per_second = std::min<std::uint64_t>(rate.per_second, 1'000'000'000);
    TokenBucket bucket;
    const std::int64_t start = any_start();
    bucket.spend(rate, at(start), rate.burst);
    std::int64_t now = start;
    constexpr std::int64_t kTokens = 1000;
    for (std::int64_t token = 0; token < kTokens; ++token) {
      now += bucket.wait(rate, at(now)).count();
      RC_ASSERT(bucket.take(rate, at(now)));
    }
    RC_ASSERT(earned_at_most(rate, now - start) >= kTokens);
    RC_ASSERT(earned_at_most(rate, now - start - 1) <= kTokens);
  }));
}

TEST_CASE("an overdrawn bucket makes later requests wait") {
  const Rate rate{10, 5};
  TokenBucket bucket;
  bucket.spend(rate, at(0), 25);
  CHECK(bucket.level(rate, at(0)) == -20);
  CHECK(bucket.wait(rate, at(0)) == std::chrono::milliseconds{2100});
  CHECK(bucket.level(rate, at(10'000'000'000)) == 5);
}

TEST_CASE("a bucket begins full, at the clock's zero as well") {
  const Rate rate{1, 3};
  TokenBucket bucket;
  CHECK(bucket.take(rate, at(0), 3));
  CHECK_FALSE(bucket.take(rate, at(0)));
}

TEST_CASE("without a limit everything is there at once") {
  TokenBucket bucket;
  CHECK(bucket.take({}, at(0), UINT64_MAX));
  bucket.spend({}, at(0), UINT64_MAX);
  CHECK(bucket.wait({}, at(0), UINT64_MAX) == nanoseconds{});
}

TEST_CASE("more than a burst is waited for as a burst") {
  const Rate rate{10, 5};
  TokenBucket bucket;
  bucket.spend(rate, at(0), 5);
  CHECK(bucket.wait(rate, at(0), 1000) == std::chrono::milliseconds{500});
}
