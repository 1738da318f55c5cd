#include "backoff.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

namespace talus::client {

using std::chrono::milliseconds;

TEST_CASE("delays double up to the greatest, less at most half at random") {
  const bool held = rc::check("bounds", [](std::uint64_t seed) {
    const ReconnectPolicy policy{12, milliseconds{100}, milliseconds{5000}, seed};
    Backoff backoff{policy};
    std::int64_t whole = 100;
    for (int i = 0; i < policy.max_attempts; ++i) {
      const auto delay = backoff.next();
      RC_ASSERT(delay.has_value());
      RC_ASSERT(delay->count() <= whole);
      RC_ASSERT(delay->count() >= whole / 2);
      whole = std::min<std::int64_t>(whole * 2, 5000);
    }
    RC_ASSERT(!backoff.next().has_value());
  });
  REQUIRE(held);
}

TEST_CASE("the same seed gives the same delays") {
  const ReconnectPolicy policy{5, milliseconds{1000}, milliseconds{60000}, 99};
  Backoff a{policy};
  Backoff b{policy};
  for (int i = 0; i < 5; ++i) CHECK(a.next() == b.next());
}

TEST_CASE("after a reset failures count from the first again") {
  Backoff backoff{{1, milliseconds{10}, milliseconds{10}, 0}};
  REQUIRE(backoff.next().has_value());
  REQUIRE_FALSE(backoff.next().has_value());
  backoff.reset();
  CHECK(backoff.next().has_value());
}

TEST_CASE("a server may ask for a longer wait, but for none without end") {
  Backoff backoff{{4, milliseconds{10}, milliseconds{10}, 0}};
  CHECK(backoff.next(milliseconds{2'000}) == milliseconds{2'000});
  CHECK(backoff.next(milliseconds{4'294'967'295}) == kLongestRetryAfter);
  CHECK(backoff.next(milliseconds{0}) <= milliseconds{10});
}

TEST_CASE("without attempts there is no delay to wait for") {
  CHECK_FALSE(Backoff{ReconnectPolicy{}}.next().has_value());
}

}  // namespace talus::client
