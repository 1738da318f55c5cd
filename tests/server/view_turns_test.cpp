#include "net/view_turns.h"

#include <catch2/catch.hpp>
#include <deque>
#include <map>

#include <asio/io_context.hpp>

#include "runtime/manual_clock.h"

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

struct Bench {
  asio::io_context io{1};
  ManualClock clock;
  ViewTurns& turns = asio::use_service<ViewTurns>(io);
  std::deque<TimedEvent> sessions;

  TimedEvent& session() { return sessions.emplace_back(io.get_executor(), clock); }
  /// Applies the View of whoever may, at the cost given; gives the session.
  TimedEvent* apply(std::chrono::nanoseconds cost) {
    for (TimedEvent& each : sessions) {
      const auto due = turns.due(each);
      if (due == Clock::time_point::max()) continue;
      if (due > clock.now()) clock.advance(due - clock.now());
      turns.applied(each, clock.now(), cost);
      return &each;
    }
    return nullptr;
  }
};

}  // namespace

TEST_CASE("the first View of a thread is applied at once") {
  Bench bench;
  TimedEvent& only = bench.session();
  CHECK(bench.turns.due(only) == Clock::time_point::max());
  bench.turns.enter(FlowId{1}, only);
  CHECK(bench.turns.due(only) <= bench.clock.now());
}

TEST_CASE("all Views of a thread take a quarter of its time, however many sessions send them") {
  Bench bench;
  const auto began = bench.clock.now();
  for (std::uint64_t i = 0; i < 50; ++i) bench.turns.enter(FlowId{i}, bench.session());
  std::chrono::nanoseconds spent{};
  while (bench.apply(3ms) != nullptr) spent += 3ms;
  CHECK(spent == 150ms);
  CHECK(bench.clock.now() - began == 49 * 4 * 3ms);
}

TEST_CASE("flows share the thread's time for Views, not sessions, and not Views") {
  Bench bench;
  constexpr FlowId kCrowd{1};
  constexpr FlowId kDear{2};
  std::map<TimedEvent*, FlowId> flows;
  for (int i = 0; i < 2; ++i) flows[&bench.session()] = FlowId{3};
  for (int i = 0; i < 100; ++i) flows[&bench.session()] = kCrowd;
  for (int i = 0; i < 3; ++i) flows[&bench.session()] = kDear;
  for (const auto& [session, flow] : flows) bench.turns.enter(flow, *session);
  std::map<FlowId, std::chrono::nanoseconds> spent;
  for (int view = 0; view < 2000; ++view) {
    TimedEvent* next = nullptr;
    for (const auto& [session, flow] : flows) {
      if (bench.turns.due(*session) != Clock::time_point::max()) next = session;
    }
    REQUIRE(next != nullptr);
    const FlowId flow = flows.at(next);
    const std::chrono::nanoseconds cost = flow == kDear ? 20ms : 1ms;
    bench.turns.applied(*next, bench.clock.now(), cost);
    spent[flow] += cost;
    bench.turns.enter(flow, *next);  // each always has another
  }
  const auto close = [](std::chrono::nanoseconds a, std::chrono::nanoseconds b) {
    return std::abs((a - b).count()) <= std::chrono::nanoseconds{25ms}.count();
  };
  CHECK(close(spent[FlowId{3}], spent[kCrowd]));
  CHECK(close(spent[FlowId{3}], spent[kDear]));
}

TEST_CASE("a session that leaves with the turn gives it to the next") {
  Bench bench;
  TimedEvent& first = bench.session();
  TimedEvent& second = bench.session();
  bench.turns.enter(FlowId{1}, first);
  bench.turns.enter(FlowId{2}, second);
  bench.turns.leave(first);
  bench.turns.leave(first);
  CHECK(bench.turns.due(first) == Clock::time_point::max());
  CHECK(bench.turns.due(second) <= bench.clock.now());
  bench.turns.leave(second);
  CHECK(bench.turns.due(second) == Clock::time_point::max());
}
