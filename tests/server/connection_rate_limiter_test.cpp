#include "net/connection_rate_limiter.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

using namespace talus::server;
using std::chrono::milliseconds;
using talus::server::Clock;

namespace {

const auto kHere = asio::ip::make_address("192.0.2.1");
const auto kThere = asio::ip::make_address("192.0.2.2");
const Clock::time_point kNow{std::chrono::hours{1}};

bool takes(ConnectionRateLimiter& limiter, const asio::ip::address& address, Clock::time_point now) {
  return limiter.admit(address, now) == Clock::duration::zero();
}

int taken(ConnectionRateLimiter& limiter, const asio::ip::address& address, Clock::time_point now,
          int tries) {
  int count = 0;
  for (int i = 0; i < tries; ++i) count += takes(limiter, address, now) ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("an address begins its burst at once, and no more") {
  ConnectionRateLimiter limiter{10, 5, 1};
  CHECK(taken(limiter, kHere, kNow, 20) == 5);
}

TEST_CASE("one address's rate is nothing to another's") {
  ConnectionRateLimiter limiter{10, 5, 1};
  (void)taken(limiter, kHere, kNow, 20);
  CHECK(taken(limiter, kThere, kNow, 20) == 5);
}

TEST_CASE("addresses of one IPv6 /64 network share a rate") {
  ConnectionRateLimiter limiter{10, 5, 1};
  (void)taken(limiter, asio::ip::make_address("2001:db8::1"), kNow, 20);
  CHECK_FALSE(takes(limiter, asio::ip::make_address("2001:db8::2"), kNow));
  CHECK(takes(limiter, asio::ip::make_address("2001:db8:0:1::2"), kNow));
}

TEST_CASE("an IPv4 address shares a rate with itself mapped into IPv6") {
  ConnectionRateLimiter limiter{10, 5, 1};
  (void)taken(limiter, kHere, kNow, 20);
  CHECK_FALSE(takes(limiter, asio::ip::make_address("::ffff:192.0.2.1"), kNow));
  CHECK(takes(limiter, asio::ip::make_address("::ffff:192.0.2.2"), kNow));
}

TEST_CASE("a client that waits for the given time is accepted, and not before") {
  ConnectionRateLimiter limiter{10, 1, 1};
  REQUIRE(takes(limiter, kHere, kNow));
  const auto wait = limiter.admit(kHere, kNow);
  CHECK(wait == milliseconds{100});
  CHECK_FALSE(takes(limiter, kHere, kNow + wait - Clock::duration{1}));
  CHECK(takes(limiter, kHere, kNow + wait));
}

TEST_CASE("a bucket fills to its burst and not beyond") {
  ConnectionRateLimiter limiter{10, 5, 1};
  (void)taken(limiter, kHere, kNow, 20);
  CHECK(taken(limiter, kHere, kNow + std::chrono::hours{1}, 20) == 5);
}

TEST_CASE("in any time t an address begins at most burst + rate * t") {
  const auto holds = rc::check([] {
    const auto rate = *rc::gen::inRange<std::uint64_t>(1, 50);
    const auto burst = *rc::gen::inRange<std::uint64_t>(1, 50);
    ConnectionRateLimiter limiter{rate, burst, 1};
    const auto pauses = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 200));
    Clock::time_point now = kNow;
    double count = 0;
    for (const int pause : pauses) {
      now += milliseconds{pause};
      count += takes(limiter, kHere, now) ? 1 : 0;
      const double seconds = std::chrono::duration<double>(now - kNow).count();
      RC_ASSERT(count <= static_cast<double>(burst) + static_cast<double>(rate) * seconds + 1e-3);
    }
  });
  CHECK(holds);
}

TEST_CASE("any number of addresses is served, and the one that owes most is kept") {
  ConnectionRateLimiter limiter{10, 5, 1};
  (void)taken(limiter, kHere, kNow, 20);
  constexpr std::uint32_t kMany = 4 * ConnectionRateLimiter::kSets * ConnectionRateLimiter::kEntriesPerSet;
  std::uint32_t refused = 0;
  for (std::uint32_t i = 0; i < kMany; ++i)
    refused += takes(limiter, asio::ip::address_v4{i << 8}, kNow) ? 0 : 1;
  CHECK(refused == 0);
  CHECK_FALSE(takes(limiter, kHere, kNow));
}
