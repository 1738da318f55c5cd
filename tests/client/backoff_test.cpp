#include <rapidcheck.h>
#include <talus/client/backoff.h>
#include <catch2/catch.hpp>

namespace talus::client {

using std::chrono::milliseconds;

TEST_CASE("delays are anything up to a bound that doubles up to the greatest") {
  const bool held = rc::check("bounds", [](std::uint64_t seed) {
    const ReconnectPolicy policy{12, milliseconds{100}, milliseconds{5000}, seed};
    Backoff backoff{policy};
    std::int64_t most = 100;
    for (int i = 0; i < policy.max_attempts; ++i) {
      const auto delay = backoff.next();
      RC_ASSERT(delay.has_value());
      RC_ASSERT(delay->count() >= 0);
      RC_ASSERT(delay->count() <= most);
      most = std::min<std::int64_t>(most * 2, 5000);
    }
    RC_ASSERT(!backoff.next().has_value());
  });
  REQUIRE(held);
}

TEST_CASE("the same seed gives the same delays, and no seed each client its own") {
  ReconnectPolicy policy{5, milliseconds{100'000}, milliseconds{6'000'000}, 99};
  const auto delays = [&] {
    Backoff backoff{policy};
    std::vector<milliseconds> all;
    for (int i = 0; i < 5; ++i) all.push_back(*backoff.next());
    return all;
  };
  CHECK(delays() == delays());
  policy.seed.reset();
  CHECK(delays() != delays());  // the same by chance once in 10^27
}

TEST_CASE("a crowd that was sent away at once returns evenly over the first delay") {
  constexpr int kClients = 1000;
  constexpr milliseconds kTold{2'000};
  std::vector<int> tenths(10);
  for (std::uint64_t seed = 0; seed < kClients; ++seed) {
    const auto delay = Backoff{{1, milliseconds{499}, milliseconds{10'000}, seed}}.next(kTold);
    REQUIRE(*delay >= kTold);
    REQUIRE(*delay < kTold + milliseconds{500});
    ++tenths[static_cast<std::size_t>((*delay - kTold).count() / 50)];
  }
  // 100 each, more or less: six times the standard deviation of 9.5.
  for (const int count : tenths) CHECK(std::abs(count - kClients / 10) < 57);
}

TEST_CASE("after a reset failures count from the first again") {
  Backoff backoff{{1, milliseconds{10}, milliseconds{10}, 0}};
  REQUIRE(backoff.next().has_value());
  REQUIRE_FALSE(backoff.next().has_value());
  backoff.reset();
  CHECK(backoff.next().has_value());
}

TEST_CASE("a server may ask for a longer wait, but not for an endless one") {
  Backoff backoff{{2, milliseconds{10}, milliseconds{10}, 0}};
  const auto told = backoff.next(milliseconds{2'000});
  CHECK(told >= milliseconds{2'000});
  CHECK(told <= milliseconds{2'010});
  CHECK(backoff.next(milliseconds{4'294'967'295}) <= kLongestRetryAfter + milliseconds{10});
}

TEST_CASE("without attempts the delay is zero") {
  CHECK_FALSE(Backoff{ReconnectPolicy{}}.next().has_value());
}

}  // namespace talus::client
