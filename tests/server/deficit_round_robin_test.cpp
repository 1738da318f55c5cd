#include "limits/flows/deficit_round_robin.h"

#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <vector>

using namespace talus::server;

namespace {

/// Entrants by number; each of `wanting` always has a piece of its cost.
struct Turns {
  DeficitRoundRobin<int> turns{Newcomers::first};
  std::map<int, std::int64_t> costs;
  std::set<int> wanting;

  void want(int id) {
    wanting.insert(id);
    turns.enter(id);
  }
  std::optional<int> next(std::int64_t quantum) {
    const auto wants = [&](int id) { return wanting.contains(id); };
    const auto id = turns.next(quantum, wants, wants);
    if (id) turns.charge(*id, costs.at(*id));
    return id;
  }
};

}  // namespace

TEST_CASE("a turn lasts until its quantum is spent") {
  Turns all;
  all.costs = {{1, 25}, {2, 100}};
  all.want(1);
  all.want(2);
  std::vector<int> order;
  for (int piece = 0; piece < 10; ++piece) order.push_back(*all.next(100));
  CHECK(order == std::vector{1, 1, 1, 1, 2, 1, 1, 1, 1, 2});
}

TEST_CASE("a piece that overdraws is paid off by the turns that follow") {
  Turns all;
  all.costs = {{1, 400}, {2, 100}};
  all.want(1);
  all.want(2);
  std::vector<int> order;
  for (int piece = 0; piece < 10; ++piece) order.push_back(*all.next(100));
  CHECK(order == std::vector{1, 2, 2, 2, 2, 1, 2, 2, 2, 2});
}

TEST_CASE("where all owe, rounds pass at once until one may begin") {
  Turns all;
  all.costs = {{1, 1'000'000'000'000}};
  all.want(1);
  CHECK(all.next(1) == 1);
  CHECK(all.next(1) == 1);
}

TEST_CASE("where nobody has anything, nobody is owed anything") {
  Turns all;
  all.costs = {{1, 1000}, {2, 100}};
  all.want(1);
  CHECK(all.next(100) == 1);
  all.wanting.clear();
  CHECK_FALSE(all.next(100).has_value());
  all.want(1);
  all.want(2);
  CHECK(all.next(100) == 1);
}

TEST_CASE("an entrant that left owing still owes while others are there") {
  Turns all;
  all.costs = {{1, 300}, {2, 100}};
  all.want(1);
  all.want(2);
  CHECK(all.next(100) == 1);
  all.wanting.erase(1);
  CHECK(all.next(100) == 2);
  all.want(1);
  CHECK(all.next(100) == 2);
  CHECK(all.next(100) == 2);
  CHECK(all.next(100) == 1);
}

TEST_CASE("newcomers go first, or last, as the round robin was told") {
  for (const Newcomers newcomers : {Newcomers::first, Newcomers::last}) {
    Turns all{DeficitRoundRobin<int>{newcomers}, {{1, 100}, {2, 100}, {3, 100}}, {}};
    all.want(1);
    all.want(2);
    CHECK(all.next(100) == 1);
    CHECK(all.next(100) == 2);
    all.want(3);
    CHECK(all.next(100) == (newcomers == Newcomers::first ? 3 : 1));
  }
}
