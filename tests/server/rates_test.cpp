#include "rates/rates.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <thread>
#include <vector>

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

constexpr SessionRates::Time kStart{1000s};

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
  SessionRates rates{none, nullptr};
  rates.sent(kStart, 1'000'000, std::size_t{1} << 40);
  CHECK(refused(rates, 1000) == 0);
  CHECK(rates.chunks_due(kStart).at == kStart);
  CHECK(rates.allowance(kStart).chunks == SIZE_MAX);
}

TEST_CASE("a refused request learns when one is granted") {
  const RateLimits limits = requests({10, 2});
  SessionRates rates{limits, nullptr};
  CHECK(refused(rates, 2) == 0);
  const auto refusal = rates.refuse_request(kStart);
  REQUIRE(refusal);
  CHECK(refusal->kind == RateKind::session_requests);
  CHECK(refusal->wait == 100ms);
  CHECK(rates.refuse_request(kStart + 99ms));
  CHECK_FALSE(rates.refuse_request(kStart + 100ms));
}

TEST_CASE("a client that was refused a burst and asks on is abusive") {
  const RateLimits limits = requests({10, 20});
  SessionRates rates{limits, nullptr};
  (void)refused(rates, 20);
  for (int ask = 0; ask < 20; ++ask) CHECK_FALSE(rates.refuse_request(kStart)->abusive);
  CHECK(rates.refuse_request(kStart)->abusive);
}

TEST_CASE("a client that waits as refusals say is never abusive") {
  const RateLimits limits = requests({10, 2});
  SessionRates rates{limits, nullptr};
  auto now = kStart;
  for (int ask = 0; ask < 1000; ++ask) {
    const auto refusal = rates.refuse_request(now);
    if (!refusal) continue;
    REQUIRE_FALSE(refusal->abusive);
    now += refusal->wait;
  }
}

TEST_CASE("a wait for chunks names its rate once") {
  const RateLimits limits{{{10, 3}, {}, {}}, {}};
  SessionRates rates{limits, nullptr};
  rates.sent(kStart, 3, 0);
  CHECK(rates.chunks_due(kStart).throttled == RateKind::session_chunks);
  CHECK_FALSE(rates.chunks_due(kStart).throttled);
  CHECK_FALSE(rates.chunks_due(kStart + 1s).throttled);
  rates.sent(kStart + 1s, 10, 0);
  CHECK(rates.chunks_due(kStart + 1s).throttled == RateKind::session_chunks);
}

TEST_CASE("the longest of the waits counts") {
  const RateLimits limits{{{10, 1}, {1000, 1000}, {}}, {}};
  SessionRates rates{limits, nullptr};
  rates.sent(kStart, 1, 3000);
  const auto due = rates.chunks_due(kStart);
  CHECK(due.throttled == RateKind::session_bytes);
  CHECK(due.at == kStart + 2001ms);
}

TEST_CASE("the smaller of the allowances counts") {
  const RateLimits limits{{{10, 5}, {}, {}}, {{10, 3}, {1000, 500}, {}}};
  SessionRates rates{limits, std::make_shared<AddressBuckets>()};
  CHECK(rates.allowance(kStart).chunks == 3);
  CHECK(rates.allowance(kStart).bytes == 500);
}

TEST_CASE("what one session of an address sends, another may not") {
  const RateLimits limits{{}, {{10, 3}, {}, {}}};
  const auto address = std::make_shared<AddressBuckets>();
  SessionRates one{limits, address};
  SessionRates other{limits, address};
  one.sent(kStart, 2, 0);
  CHECK(other.allowance(kStart).chunks == 1);
  other.sent(kStart, 1, 0);
  CHECK(one.chunks_due(kStart).throttled == RateKind::address_chunks);
}

TEST_CASE("a session far over its bytes in control frames may ask no more") {
  const RateLimits limits{{{}, {1000, 1000}, {}}, {}};
  SessionRates rates{limits, nullptr};
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
      SessionRates rates{limits, address};
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
