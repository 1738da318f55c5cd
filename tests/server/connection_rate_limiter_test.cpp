#include "net/handshake_budget.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

using namespace talus::server;
using std::chrono::milliseconds;
using Clock = HandshakeBudget::Clock;

namespace {

const auto kHere = asio::ip::make_address("192.0.2.1");
const auto kThere = asio::ip::make_address("192.0.2.2");
const Clock::time_point kNow{std::chrono::hours{1}};

bool takes(HandshakeBudget& budget, const asio::ip::address& address, Clock::time_point now) {
  return budget.take(address, now) == Clock::duration::zero();
}

int taken(HandshakeBudget& budget, const asio::ip::address& address, Clock::time_point now, int tries) {
  int count = 0;
  for (int i = 0; i < tries; ++i) count += takes(budget, address, now) ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("an address begins its burst at once, and no more") {
  HandshakeBudget budget{10, 5, 1};
  CHECK(taken(budget, kHere, kNow, 20) == 5);
}

TEST_CASE("one address's budget is nothing to another's") {
  HandshakeBudget budget{10, 5, 1};
  (void)taken(budget, kHere, kNow, 20);
  CHECK(taken(budget, kThere, kNow, 20) == 5);
}

TEST_CASE("addresses of one IPv6 /64 network share a budget") {
  HandshakeBudget budget{10, 5, 1};
  (void)taken(budget, asio::ip::make_address("2001:db8::1"), kNow, 20);
  CHECK_FALSE(takes(budget, asio::ip::make_address("2001:db8::2"), kNow));
  CHECK(takes(budget, asio::ip::make_address("2001:db8:0:1::2"), kNow));
}

TEST_CASE("who waits as long as it is told gets in, and not before") {
  HandshakeBudget budget{10, 1, 1};
  REQUIRE(takes(budget, kHere, kNow));
  const auto wait = budget.take(kHere, kNow);
  CHECK(wait == milliseconds{100});
  CHECK_FALSE(takes(budget, kHere, kNow + wait - Clock::duration{1}));
  CHECK(takes(budget, kHere, kNow + wait));
}

TEST_CASE("a bucket fills to its burst and not beyond") {
  HandshakeBudget budget{10, 5, 1};
  (void)taken(budget, kHere, kNow, 20);
  CHECK(taken(budget, kHere, kNow + std::chrono::hours{1}, 20) == 5);
}

TEST_CASE("in any time t an address begins at most burst + rate * t") {
  const auto holds = rc::check([] {
    const auto rate = *rc::gen::inRange<std::uint64_t>(1, 50);
    const auto burst = *rc::gen::inRange<std::uint64_t>(1, 50);
    HandshakeBudget budget{rate, burst, 1};
    const auto pauses = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 200));
    Clock::time_point now = kNow;
    double count = 0;
    for (const int pause : pauses) {
      now += milliseconds{pause};
      count += takes(budget, kHere, now) ? 1 : 0;
      const double seconds = std::chrono::duration<double>(now - kNow).count();
      RC_ASSERT(count <= static_cast<double>(burst) + static_cast<double>(rate) * seconds + 1e-3);
    }
  });
  CHECK(holds);
}

TEST_CASE("however many addresses come, none is refused for the others, and who owes most is remembered") {
  HandshakeBudget budget{10, 5, 1};
  (void)taken(budget, kHere, kNow, 20);
  constexpr std::uint32_t kMany = 4 * HandshakeBudget::kSets * HandshakeBudget::kPlaces;
  std::uint32_t refused = 0;
  for (std::uint32_t i = 0; i < kMany; ++i)
    refused += takes(budget, asio::ip::address_v4{i << 8}, kNow) ? 0 : 1;
  CHECK(refused == 0);
  CHECK_FALSE(takes(budget, kHere, kNow));
}
