#include "limits/rates/rates.h"

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

TEST_CASE("each refused request gets the time at which it has room behind earlier refusals") {
  const RateLimits limits = requests({10, 2});
  SessionRates rates{limits, nullptr, kInFlight};
  CHECK(refused(rates, 2) == 0);
  for (int k = 1; k <= 100; ++k) CHECK(rates.refuse_request(kStart)->wait == k * 100ms);
  for (int k = 1; k <= 100; ++k) {
    CHECK(rates.refuse_request(kStart + k * 100ms - 1ns));
    CHECK_FALSE(rates.refuse_request(kStart + k * 100ms));
  }
}

TEST_CASE("new chunks count for an address, by the hour, and an edit delayed by its voxels is not charged") {
  RateLimits limits;
  limits.session.voxels = {10, 20};
  limits.address.new_chunks = {2, 3 * kNewChunkTokens};  // two an hour, three saved up
  const auto address = std::make_shared<AddressBuckets>(limits.address);
  SessionRates one{limits, address, kInFlight};
  SessionRates other{limits, address, kInFlight};
  CHECK_FALSE(one.refuse_edit(kStart, {1, 2}));
  const auto refusal = other.refuse_edit(kStart, {1, 2});
  REQUIRE(refusal);
  CHECK(refusal->kind == RateKind::address_new_chunks);
  CHECK(refusal->wait == 30min);
  CHECK_FALSE(refusal->abusive);
  CHECK_FALSE(other.refuse_edit(kStart, {1, 0}));  // where somebody edited before
  CHECK(one.refuse_edit(kStart, {20, 1})->kind == RateKind::session_voxels);
  CHECK_FALSE(other.refuse_edit(kStart, {1, 1}));
  CHECK(other.refuse_edit(kStart + 30min - 1ns, {1, 1}));
  CHECK_FALSE(other.refuse_edit(kStart + 30min, {1, 1}));
  CHECK(address->saved_up_in(kStart + 30min) == 90min);
  // A game server edits for many.
  SessionRates gateway{limits.of_gateway(), address, kInFlight};
  CHECK_FALSE(gateway.refuse_edit(kStart, {1, 1'000}));
}

TEST_CASE("a bucket that moves to another rate keeps its tokens and its debt, and no more than the burst") {
  REQUIRE(rc::check("the level stays, up to the burst", [] {
    const auto rate = [] {
      return Rate{*rc::gen::inRange<std::uint64_t>(1, 1 << 20), *rc::gen::inRange<std::uint64_t>(1, 1000)};
    };
    const Rate from = rate();
    const Rate to = rate();
    const auto now = kStart + std::chrono::nanoseconds{*rc::gen::inRange<std::int64_t>(0, 1'000'000'000'000)};
    TokenBucket bucket;
    bucket.spend(from, now, *rc::gen::inRange<std::uint64_t>(0, 3000));
    const std::int64_t level = bucket.level(from, now);
    RC_ASSERT(bucket.moved(from, to, now).level(to, now) ==
              std::min(level, static_cast<std::int64_t>(to.burst)));
    RC_ASSERT(bucket.moved(from, {}, now).moved({}, to, now).level(to, now) ==
              static_cast<std::int64_t>(to.burst));
  }));
}

TEST_CASE("sessions that change to other rates share what is left of their address's") {
  const RateLimits before{{}, {{}, {}, {1, 10}}};
  const RateLimits after{{}, {{}, {}, {1, 5}}};
  const auto old_buckets = std::make_shared<AddressBuckets>(before.address);
  SessionRates one{before, old_buckets, kInFlight};
  SessionRates other{before, old_buckets, kInFlight};
  CHECK(refused(one, 7) == 0);
  const auto buckets = std::make_shared<AddressBuckets>(*old_buckets, after.address, kStart);
  one.change(after, buckets, kStart);
  other.change(after, buckets, kStart);
  CHECK(refused(one, 2) == 0);
  CHECK(refused(other, 2) == 1);
  CHECK(refused(other, 10, kStart + 100s) == 5);
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

TEST_CASE("a client that waits for the given time is never abusive, whatever is in flight") {
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
      if (!due.empty()) now = std::max(now, *due.rbegin());  // those it gives up count until they have room
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
    const std::uint64_t bound = 2 * (session.burst + shared.burst) + 3 * (in_flight + fastest) + 10;
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
  CHECK(due.at == kStart + 2010ms);  // a batch of 10 bytes
}

TEST_CASE("the smaller of the allowances counts") {
  const RateLimits limits{{{10, 5}, {}, {}}, {{10, 3}, {1000, 500}, {}}};
  SessionRates rates{limits, std::make_shared<AddressBuckets>(), kInFlight};
  CHECK(rates.allowance(kStart).chunks == 3);
  CHECK(rates.allowance(kStart).bytes == 500);
}

TEST_CASE("chunks sent to one session of an address count for another") {
  const RateLimits limits{{}, {{10, 3}, {}, {}}};
  const auto address = std::make_shared<AddressBuckets>();
  SessionRates one{limits, address, kInFlight};
  SessionRates other{limits, address, kInFlight};
  one.sent(kStart, 2, 0);
  CHECK(other.allowance(kStart).chunks == 1);
  other.sent(kStart, 1, 0);
  CHECK(one.chunks_due(kStart).throttled == RateKind::address_chunks);
}

TEST_CASE("a session's reservation of its address's rates is free for others when it ends") {
  const RateLimits limits{{}, {{1000, 100}, {100'000, 10'000}, {}}};
  const auto address = std::make_shared<AddressBuckets>();
  SessionRates one{limits, address, kInFlight};
  one.sent(kStart, 100, 10'000);
  CHECK(one.chunks_due(kStart).at == kStart + 10ms);
  one.sent(kStart + 10ms, 4, 300);
  const auto level = [&](SessionRates::Time now) {
    return std::pair{address->chunks.load().level(limits.address.chunks, now),
                     address->bytes.load().level(limits.address.bytes, now)};
  };
  CHECK(level(kStart + 10ms) == std::pair<std::int64_t, std::int64_t>{0, 0});
  one.give_back();
  CHECK(level(kStart + 10ms) == std::pair<std::int64_t, std::int64_t>{6, 700});
  one.give_back();
  CHECK(level(kStart + 10ms) == std::pair<std::int64_t, std::int64_t>{6, 700});
  // Not more than a burst.
  CHECK(level(kStart + 10s) == std::pair<std::int64_t, std::int64_t>{100, 10'000});
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

TEST_CASE("a session that its own rate holds sends what 10 ms earn at once") {
  const RateLimits limits{{{1000, 5}, {}, {}}, {}};
  SessionRates rates{limits, nullptr, 100};
  rates.sent(kStart, 5, 0);
  const auto due = rates.chunks_due(kStart);
  CHECK(due.at == kStart + 5ms);  // a burst is less
  const RateLimits larger{{{1000, 500}, {}, {}}, {}};
  SessionRates others{larger, nullptr, 100};
  others.sent(kStart, 500, 0);
  CHECK(others.chunks_due(kStart).at == kStart + 10ms);
  CHECK(others.chunks_due(kStart + 5ms).at == kStart + 10ms);
  CHECK(others.chunks_due(kStart + 10ms).at == kStart + 10ms);
  CHECK(others.allowance(kStart + 10ms).chunks == 10);
}

TEST_CASE("many sessions of an address are woken once a batch, have equal shares, and keep its rate") {
  CHECK(rc::check([] {
    const auto per_second = *rc::gen::inRange<std::uint64_t>(1000, 20'000);
    const auto chunk_bytes = *rc::gen::inRange<std::size_t>(100, 5000);
    const bool bytes_too = *rc::gen::arbitrary<bool>();
    const RateLimits limits{
        {},
        {{per_second, per_second / 10}, bytes_too ? Rate{per_second * 1000, per_second * 100} : Rate{}, {}}};
    const auto address = std::make_shared<AddressBuckets>();
    struct Player {
      SessionRates rates;
      SessionRates::Time wakes = kStart;
      std::uint64_t chunks = 0;
    };
    std::vector<Player> players;
    const auto count = *rc::gen::inRange<std::size_t>(2, 60);
    for (std::size_t i = 0; i < count; ++i) players.push_back({SessionRates{limits, address, 100}});
    std::uint64_t chunks = 0;
    std::uint64_t bytes = 0;
    std::uint64_t wakes = 0;
    const auto end = kStart + 4s;
    for (;;) {
      Player& player = *std::min_element(players.begin(), players.end(),
                                         [](const Player& a, const Player& b) { return a.wakes < b.wakes; });
      const auto now = player.wakes;
      if (now >= end) break;
      ++wakes;
      const auto due = player.rates.chunks_due(now);
      if (due.at > now) {
        player.wakes = due.at;
        continue;
      }
      const auto allowance = player.rates.allowance(now);
      RC_ASSERT(allowance.chunks > 0);
      RC_ASSERT(allowance.bytes > 0);
      std::size_t sent = 0;
      while (sent < std::min<std::size_t>(allowance.chunks, 64) && sent * chunk_bytes < allowance.bytes)
        ++sent;
      player.rates.sent(now, sent, sent * chunk_bytes);
      player.chunks += sent;
      chunks += sent;
      bytes += sent * chunk_bytes;
    }
    const Rate& rate = limits.address.chunks;
    RC_ASSERT(chunks <= rate.burst + 4 * rate.per_second);
    const double used = static_cast<double>(chunks) / static_cast<double>(rate.burst + 4 * rate.per_second);
    const Rate& of_bytes = limits.address.bytes;
    const double bytes_used =
        bytes_too ? static_cast<double>(bytes) / static_cast<double>(of_bytes.burst + 4 * of_bytes.per_second)
                  : 0;
    // What is reserved at the end is not sent.
    RC_ASSERT(std::max(used, bytes_used) > 0.7);
    RC_ASSERT(wakes < 2000 + chunks);
    if (per_second >= 2000 && !bytes_too) RC_ASSERT(wakes < chunks / 4 + 200);
    const auto [least, most] = std::minmax_element(
        players.begin(), players.end(), [](const Player& a, const Player& b) { return a.chunks < b.chunks; });
    RC_ASSERT(most->chunks - least->chunks <= rate.burst + 64);
  }));
}
