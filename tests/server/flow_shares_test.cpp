#include "limits/flows/flow_shares.h"

#include <catch2/catch.hpp>
#include <chrono>
#include <deque>
#include <set>
#include <utility>

#include "limits/memory/memory_reservation.h"
#include "runtime/manual_clock.h"

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

constexpr Clock::time_point kBegin = Clock::time_point{} + 1h;

/// Parts, each with a number, and which of them have given way.
struct Pool {
  FlowShares shares{3s};
  std::deque<FlowShares::Part> parts;
  std::set<std::size_t> gone;

  void enter(std::uint64_t flow, std::uint64_t amount, Clock::time_point progress) {
    const std::size_t number = parts.size();
    parts.emplace_back(shares, FlowId{flow}, amount, progress);
    parts.back().set_give_way([this, number] { gone.insert(number); });
  }
  [[nodiscard]] bool make_room(std::uint64_t flow, std::uint64_t sure = 0, Clock::time_point now = kBegin) {
    return shares.make_room(FlowId{flow}, 1, sure, now).has_value();
  }
};

}  // namespace

TEST_CASE("the flow that holds most gives way, by the part without progress for longest") {
  Pool pool;
  pool.enter(1, 1, kBegin - 3s);
  for (const auto ago : {1s, 2s, 0s}) pool.enter(2, 1, kBegin - ago);
  CHECK(pool.make_room(3));
  CHECK(pool.gone == std::set<std::size_t>{2});
  CHECK(pool.shares.size() == 3);
  CHECK(pool.make_room(1) == false);  // it would have as many
  CHECK(pool.make_room(2) == false);
}

TEST_CASE("a part that stands still for too long gives way, even the only one of its flow") {
  Pool pool;
  pool.enter(1, 1, kBegin - 4s);
  pool.enter(2, 1, kBegin - 5s);
  CHECK(pool.make_room(3));
  CHECK(pool.gone == std::set<std::size_t>{1});
  pool.parts[0].progress(kBegin);
  CHECK_FALSE(pool.make_room(3));
}

TEST_CASE("a sure amount, the only part of a flow, and a part that cannot end do not give way") {
  Pool pool;
  pool.enter(1, 100, Clock::time_point::max());
  CHECK_FALSE(pool.make_room(2));
  pool.enter(1, 1, Clock::time_point::max());
  CHECK_FALSE(pool.make_room(2, 101));
  CHECK(pool.make_room(2, 100));
  CHECK(pool.gone == std::set<std::size_t>{0});  // the larger
  for (int i = 0; i < 3; ++i) pool.parts.emplace_back(pool.shares, FlowId{5}, 1, kBegin - 1h);
  CHECK_FALSE(pool.make_room(2));
}

TEST_CASE("a part counts for the flow that it moved to, until it has given way") {
  Pool pool;
  for (int i = 0; i < 4; ++i) pool.enter(1, 1, kBegin);
  pool.parts[0].move_to(FlowId{2});
  pool.parts[1].move_to(FlowId{2});
  CHECK(pool.make_room(3));  // of 1 or 2
  CHECK(pool.make_room(3));
  CHECK_FALSE(pool.make_room(3));
  for (auto& part : pool.parts) part.move_to(FlowId{4});
  pool.parts.clear();
  CHECK(pool.shares.size() == 0);
}

TEST_CASE("one greedy flow never keeps others out, however many come") {
  Pool pool;
  for (int i = 0; i < 100; ++i) pool.enter(0, 1, kBegin);
  for (std::uint64_t flow = 1; flow < 100; ++flow) {
    REQUIRE(pool.make_room(flow));
    pool.enter(flow, 1, kBegin);
  }
  CHECK(pool.shares.size() == 100);
  CHECK(pool.gone.size() == 99);
  CHECK_FALSE(pool.make_room(100));  // each has one
}

TEST_CASE("a client that drains less than the least rate falls behind, and gives way while memory is short") {
  constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20;
  MemoryBudget budget{1024 * kMebibyte};
  int slow_ended = 0;
  int fast_ended = 0;
  MemoryReservation slow{budget, MemoryUse::sessions};
  MemoryReservation fast{budget, MemoryUse::sessions};
  slow.share(FlowId{1}, [&] { ++slow_ended; });
  fast.share(FlowId{2}, [&] { ++fast_ended; });
  slow.hold(2 * kMebibyte);
  fast.hold(2 * kMebibyte);
  budget.set(MemoryUse::store, 700 * kMebibyte);
  REQUIRE_FALSE(budget.takes_connections());
  auto now = kBegin;
  // 32 KiB in 4 s, and in 1 s.
  for (int write = 0; write < 2; ++write) {
    slow.drain_begins(now, 32 * 1024);
    for (int i = 0; i < 4; ++i) {
      fast.drain_begins(now, 32 * 1024);
      now += 1s;
      fast.drain_ends(now);
    }
    slow.drain_ends(now);
  }
  slow.drain_begins(now, 32 * 1024);
  budget.end_still_sessions(now + 2s);
  CHECK_FALSE(budget.takes_connection_of(FlowId{3}, now - 1s));  // a second behind
  CHECK(slow_ended == 0);
  SECTION("for a newcomer") {
    CHECK(budget.takes_connection_of(FlowId{3}, now + 4s));
  }
  SECTION("before one comes") {
    budget.end_still_sessions(now + 4s);
  }
  CHECK(slow_ended == 1);
  CHECK(fast_ended == 0);
}

TEST_CASE(
    "if nothing else gives way a part does that stands still for a fifth of the time, to a smaller flow") {
  Pool pool;
  pool.enter(1, 2, kBegin - 700ms);
  pool.enter(2, 2, kBegin);
  pool.enter(3, 2, Clock::time_point::max());
  CHECK_FALSE(pool.make_room(4, 9, kBegin - 200ms));  // 500 ms of 3 s
  CHECK_FALSE(pool.make_room(2, 9));                  // it would have three
  CHECK(pool.make_room(4, 9));
  CHECK(pool.gone == std::set<std::size_t>{0});
  CHECK_FALSE(pool.make_room(4, 9));
}

TEST_CASE("sessions give way to one message until their memory suffices, and not again while they end") {
  constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20;
  MemoryBudget budget{1024 * kMebibyte};
  budget.set(MemoryUse::store, 560 * kMebibyte);
  budget.set(MemoryUse::jobs, 4 * kMebibyte);
  std::deque<MemoryReservation> greedy;
  std::size_t gone = 0;
  for (int i = 0; i < 50; ++i) {
    greedy.emplace_back(budget, MemoryUse::sessions).share(FlowId{1}, [&] { ++gone; });
    greedy.back().hold(4 * kMebibyte);
  }
  REQUIRE_FALSE(budget.takes_work());
  for (int message = 0; message < 10; ++message) CHECK(budget.takes_work_of(FlowId{2}, 0, kBegin));
  // 24 of the program, 560, 4 and 200 are 148 MiB above 5/8.
  CHECK(gone == 37);
}

TEST_CASE("a part that has given way before it can end ends when it can") {
  Pool pool;
  bool ended = false;
  pool.enter(1, 1, kBegin - 4s);
  CHECK(pool.make_room(2));
  pool.parts[0].set_give_way([&] { ended = true; });
  CHECK(ended);
}

TEST_CASE("a client that takes little of a large answer falls behind") {
  MemoryBudget budget{std::uint64_t{1} << 30};
  budget.set(MemoryUse::store, std::uint64_t{700} << 20);
  bool ended = false;
  MemoryReservation answer{budget, MemoryUse::sessions};
  answer.share(FlowId{1}, [&] { ended = true; });
  answer.hold(4 << 20);
  answer.drain_begins(kBegin, 0);
  for (int i = 1; i <= 5; ++i) answer.drain_goes_on(1);
  budget.end_still_sessions(kBegin + 4s);
  CHECK_FALSE(ended);
  answer.drain_goes_on(32 * 1024);
  budget.end_still_sessions(kBegin + 6s);
  CHECK_FALSE(ended);
  budget.end_still_sessions(kBegin + 8s);
  CHECK(ended);
}

TEST_CASE("while memory is not short the slowest client stays") {
  MemoryBudget budget{std::uint64_t{1} << 30};
  bool ended = false;
  MemoryReservation slow{budget, MemoryUse::sessions};
  slow.share(FlowId{1}, [&] { ended = true; });
  slow.drain_begins(kBegin, 0);
  budget.end_still_sessions(kBegin + 1h);
  CHECK(budget.takes_connection_of(FlowId{3}, kBegin + 1h));
  CHECK_FALSE(ended);
}
