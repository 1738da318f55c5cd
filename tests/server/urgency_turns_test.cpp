#include "chunks/generation/urgency_turns.h"

#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <utility>

using namespace talus::server;

namespace {

using Turn = UrgencyTurns::Turn;

/// Clients that always have work of their urgencies, each client of a flow of its own.
struct Bench {
  UrgencyTurns turns;
  std::set<std::pair<ClientId, Urgency>> work;
  std::map<std::pair<ClientId, Urgency>, std::int64_t> time;

  void enter(std::uint64_t client, Urgency urgency) {
    work.insert({ClientId{client}, urgency});
    turns.enter({FlowId{client}, ClientId{client}, urgency});
  }
  void run(int pieces, std::int64_t cost) {
    const auto has = [this](ClientId id, Urgency urgency) { return work.contains({id, urgency}); };
    for (int i = 0; i < pieces; ++i) {
      const auto turn = turns.next(
          100, [](FlowId) { return true; }, has, has);
      REQUIRE(turn.has_value());
      turns.charge(*turn, cost);
      time[{turn->client, turn->urgency}] += cost;
    }
  }
  std::int64_t of(std::uint64_t client, Urgency urgency) { return time[{ClientId{client}, urgency}]; }
};

}  // namespace

TEST_CASE(
    "what is wanted soon gets kShare times the time of what is wanted later, whoever wants more of it") {
  Bench bench;
  for (std::uint64_t client = 1; client <= 9; ++client) bench.enter(client, Urgency::soon);
  bench.enter(10, Urgency::later);
  const std::int64_t cost = GENERATE(10, 100, 250);
  bench.run(4000, cost);
  const std::int64_t later = bench.of(10, Urgency::later);
  const std::int64_t all = 4000 * cost;
  CHECK(std::abs(all - (UrgencyTurns::kShare + 1) * later) <= 20 * std::max<std::int64_t>(cost, 100));
  for (std::uint64_t client = 1; client <= 9; ++client) {
    CHECK(std::abs(9 * bench.of(client, Urgency::soon) - (all - later)) <=
          40 * std::max<std::int64_t>(cost, 100));
  }
}

TEST_CASE("who alone has work gets all the time, and owes little for it when others come") {
  Bench bench;
  const bool soon = GENERATE(true, false);
  const Urgency first = soon ? Urgency::soon : Urgency::later;
  const Urgency second = soon ? Urgency::later : Urgency::soon;
  bench.enter(1, first);
  bench.run(1000, 100);
  CHECK(bench.of(1, first) == 100'000);
  bench.enter(2, second);
  bench.time.clear();
  bench.run(4000, 100);
  const std::int64_t fair = soon ? 300'000 : 100'000;
  CHECK(bench.of(1, first) >= fair - 7000);
  CHECK(bench.of(1, first) <= fair + 7000);
}

TEST_CASE("where what is wanted soon cannot be begun the other is") {
  UrgencyTurns turns;
  turns.enter({FlowId{1}, ClientId{1}, Urgency::soon});
  turns.enter({FlowId{2}, ClientId{2}, Urgency::later});
  const auto turn = turns.next(
      100, [](FlowId) { return true; }, [](ClientId, Urgency urgency) { return urgency == Urgency::later; },
      [](ClientId, Urgency) { return true; });
  REQUIRE(turn.has_value());
  CHECK(turn->client == ClientId{2});
}
