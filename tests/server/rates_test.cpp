#include "rates/rates.h"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <set>
#include <thread>
#include <vector>

#include <rapidcheck.h>

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

constexpr SessionRates::Time kStart{1000s};
constexpr std::uint32_t kInFlight = 100;

RateLimits requests(Rate rate) {
  return {{{}, {}, rate}, {}};
}

/// Refusals among `count` requests at once.
int refused(SessionRates& rates, int count, SessionRates::Time now = kStart) {
  int refused = 0;
  for (int ask = 0; ask < count; ++ask) refused += rates.refuse_request(now) ? 1 : 0;
  return refused;
}

}  // namespace

TEST_CASE("without limits nothing is refused or throttled") {
  const RateLimits none;
  SessionRates rates{none, nullptr, kInFlight};
  rates.sent(kStart, 1'000'000, std::size_t{1} << 40);
  CHECK(refused(rates, 1000) == 0);
  CHECK(rates.chunks_due(kStart).at == kStart);
  CHECK(rates.allowance(kStart).chunks == SIZE_MAX);
}

TEST_CASE("a refused request learns when one is granted") {
  const RateLimits limits = requests({10, 2});
  SessionRates rates{limits, nullptr, kInFlight};
  CHECK(refused(rates, 2) == 0);
  const auto refusal = rates.refuse_request(kStart);
  REQUIRE(refusal);
  CHECK(refusal->kind == RateKind::session_requests);
  CHECK(refusal->wait == 100ms);
  CHECK(rates.refuse_request(kStart + 99ms));
  CHECK_FALSE(rates.refuse_request(kStart + 100ms));
}

TEST_CASE("each refused request is told when it has room behind those refused before it") {
  const RateLimits limits = requests({10, 2});
  SessionRates rates{limits, nullptr, kInFlight};
  CHECK(refused(rates, 2) == 0);
  for (int k = 1; k <= 100; ++k) CHECK(rates.refuse_request(kStart)->wait == k * 100ms);
  for (int k = 1; k <= 100; ++k) {
    CHECK(rates.refuse_request(kStart + k * 100ms - 1ns));
    CHECK_FALSE(rates.refuse_request(kStart + k * 100ms));
  }
}

TEST_CASE("a request that its address refuses takes no token of its session") {
  const RateLimits limits{{{}, {}, {1, 3}}, {{}, {}, {1, 1}}};
  const auto address = std::make_shared<AddressBuckets>();
  SessionRates one{limits, address, kInFlight};
  CHECK(refused(one, 3) == 2);
  address->requests = TokenBucket{};
  CHECK(refused(one, 1) == 0);
  address->requests = TokenBucket{};
  CHECK(refused(one, 1) == 0);
}

TEST_CASE("a client that waits until its bytes are paid is never abusive") {
  const RateLimits limits{{{}, {1000, 1000}, {}}, {}};
  SessionRates rates{limits, nullptr, kInFlight};
  auto now = kStart;
  for (int round = 0; round < 10; ++round) {
    rates.sent(now, 0, 10'000);
    std::chrono::nanoseconds wait{};
    for (std::uint32_t ask = 0; ask < kInFlight; ++ask) {
      const auto refusal = rates.refuse_request(now);
      REQUIRE(refusal);
      REQUIRE_FALSE(refusal->abusive);
      wait = refusal->wait;
    }
    now += wait;
    CHECK_FALSE(rates.refuse_request(now));
  }
}

TEST_CASE("a client that asks on at once is abusive, after what may have been on its way") {
  const RateLimits limits = requests({10, 20});
  SessionRates rates{limits, nullptr, kInFlight};
  (void)refused(rates, 20);
  for (std::uint32_t ask = 0; ask < kInFlight + 10; ++ask) CHECK_FALSE(rates.refuse_request(kStart)->abusive);
  CHECK(rates.refuse_request(kStart)->abusive);
}

namespace {

/// Whose address has others, who take its tokens.
struct Crowd {
  RateLimits limits;
  AddressBucketsPtr address = std::make_shared<AddressBuckets>();

  void take(SessionRates::Time now, int tokens) const {
    if (!limits.address.requests.limited()) return;
    TokenBucket bucket = address->requests;
    bucket.spend(limits.address.requests, now, static_cast<std::uint64_t>(tokens));
    address->requests = bucket;
  }
};

Crowd any_crowd() {
  const auto rate = [] {
    return Rate{*rc::gen::inRange<std::uint64_t>(1, 300), *rc::gen::inRange<std::uint64_t>(1, 300)};
  };
  const int which = *rc::gen::inRange(1, 4);
  return {{{{}, {}, (which & 1) != 0 ? rate() : Rate{}}, {{}, {}, (which & 2) != 0 ? rate() : Rate{}}}};
}

}  // namespace

TEST_CASE("a client that waits as it is told is never abusive, whatever it had on its way") {
  CHECK(rc::check([] {
    const Crowd crowd = any_crowd();
    const auto in_flight = *rc::gen::inRange(1U, 1025U);
    const bool each_alone = *rc::gen::arbitrary<bool>();  // or all when the last has room
    SessionRates rates{crowd.limits, crowd.address, in_flight};
    auto now = kStart;
    for (const int pause_ms : *rc::gen::container<std::vector<int>>(5, rc::gen::inRange(0, 3000))) {
      now += std::chrono::milliseconds{pause_ms};
      std::multiset<SessionRates::Time> due;  // of requests that are not granted
      const auto burst = *rc::gen::inRange(0U, in_flight + 1);
      for (std::uint32_t ask = 0; ask < burst; ++ask) due.insert(now);
      SessionRates::Time all_due = now;
      // Others may take what it was told it would have, for ever.
      for (int ask = 0; ask < 5000 && !due.empty(); ++ask) {
        now = std::max(now, *due.begin());
        due.erase(due.begin());
        const auto refusal = rates.refuse_request(now);
        if (!refusal) continue;
        RC_ASSERT(!refusal->abusive);
        all_due = std::max(all_due, now + std::chrono::ceil<std::chrono::milliseconds>(refusal->wait));
        due.insert(now + std::chrono::ceil<std::chrono::milliseconds>(refusal->wait));
        if (each_alone || *due.begin() <= now) continue;
        const std::size_t left = due.size();
        due.clear();
        for (std::size_t again = 0; again < left; ++again) due.insert(all_due);
        crowd.take(all_due, pause_ms % 3);
      }
    }
  }));
}

TEST_CASE("a client that does not wait is abusive after a bounded number of requests") {
  CHECK(rc::check([] {
    const Crowd crowd = any_crowd();
    const auto in_flight = *rc::gen::inRange(1U, 1025U);
    SessionRates rates{crowd.limits, crowd.address, in_flight};
    const Rate session = crowd.limits.session.requests;
    const Rate shared = crowd.limits.address.requests;
    const std::uint64_t fastest = std::max(session.per_second, shared.per_second);
    // Four times as fast as it may: of four, one is granted, and of the three refusals one is forgiven.
    const auto pause = std::chrono::nanoseconds{1'000'000'000 / (4 * fastest)};
    const std::uint64_t bound = session.burst + shared.burst + 3 * (in_flight + fastest) + 10;
    auto now = kStart;
    bool abusive = false;
    for (std::uint64_t ask = 0; ask < bound && !abusive; ++ask, now += pause) {
      const auto refusal = rates.refuse_request(now);
      abusive = refusal && refusal->abusive;
    }
    RC_ASSERT(abusive);
  }));
}

TEST_CASE("a wait for chunks names its rate once") {
  const RateLimits limits{{{10, 3}, {}, {}}, {}};
  SessionRates rates{limits, nullptr, kInFlight};
  rates.sent(kStart, 3, 0);
  CHECK(rates.chunks_due(kStart).throttled == RateKind::session_chunks);
  CHECK_FALSE(rates.chunks_due(kStart).throttled);
  CHECK_FALSE(rates.chunks_due(kStart + 1s).throttled);
  rates.sent(kStart + 1s, 10, 0);
  CHECK(rates.chunks_due(kStart + 1s).throttled == RateKind::session_chunks);
}

TEST_CASE("the longest of the waits counts") {
  const RateLimits limits{{{10, 1}, {1000, 1000}, {}}, {}};
  SessionRates rates{limits, nullptr, kInFlight};
  rates.sent(kStart, 1, 3000);
  const auto due = rates.chunks_due(kStart);
  CHECK(due.throttled == RateKind::session_bytes);
  CHECK(due.at == kStart + 2001ms);
}

TEST_CASE("the smaller of the allowances counts") {
  const RateLimits limits{{{10, 5}, {}, {}}, {{10, 3}, {1000, 500}, {}}};
  SessionRates rates{limits, std::make_shared<AddressBuckets>(), kInFlight};
  CHECK(rates.allowance(kStart).chunks == 3);
  CHECK(rates.allowance(kStart).bytes == 500);
}

TEST_CASE("what one session of an address sends, another may not") {
  const RateLimits limits{{}, {{10, 3}, {}, {}}};
  const auto address = std::make_shared<AddressBuckets>();
  SessionRates one{limits, address, kInFlight};
  SessionRates other{limits, address, kInFlight};
  one.sent(kStart, 2, 0);
  CHECK(other.allowance(kStart).chunks == 1);
  other.sent(kStart, 1, 0);
  CHECK(one.chunks_due(kStart).throttled == RateKind::address_chunks);
}

TEST_CASE("a session far over its bytes in control frames may ask no more") {
  const RateLimits limits{{{}, {1000, 1000}, {}}, {}};
  SessionRates rates{limits, nullptr, kInFlight};
  rates.sent(kStart, 0, 1000 + 8192);
  CHECK_FALSE(rates.refuse_request(kStart));
  rates.sent(kStart, 0, 1);
  CHECK(rates.refuse_request(kStart)->kind == RateKind::session_bytes);
}

TEST_CASE("threads that share an address's bucket take no more than it has") {
  const RateLimits limits{{}, {{}, {}, {1, 20'000}}};
  const auto address = std::make_shared<AddressBuckets>();
  std::atomic<int> granted{0};
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&] {
      SessionRates rates{limits, address, kInFlight};
      granted += 10'000 - refused(rates, 10'000);
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(granted == 20'000);
}

TEST_CASE("a burst is what the rate earns in a pause, and at least one token") {
  CHECK(Rate::with_burst_of(1000, 500ms) == Rate{1000, 500});
  CHECK(Rate::with_burst_of(1, 500ms) == Rate{1, 1});
  CHECK_FALSE(Rate::with_burst_of(0, 500ms).limited());
}
