#include "limits/flows/fair_order.h"

#include <catch2/catch.hpp>
#include <map>

using namespace talus::server;

namespace {

struct Crowd {
  FairOrder<int> order;
  std::map<int, std::uint64_t> costs;

  void join(int id, std::uint64_t cost) {
    costs[id] = cost;
    order.enter(id, cost);
  }
  /// Who goes now; all but `seldom` have more at once.
  int step(int seldom = -1) {
    const auto next = order.next();
    REQUIRE(next.has_value());
    if (*next != seldom) order.enter(*next, costs.at(*next));
    return *next;
  }
  /// Of others that go before `id`, which enters now.
  int waits(int id) {
    order.enter(id, costs.at(id));
    int others = 0;
    while (step(id) != id) ++others;
    return others;
  }
};

}  // namespace

TEST_CASE("shares are equal by cost") {
  Crowd crowd;
  std::map<int, int> went;
  for (const auto& [id, cost] : {std::pair{1, 10}, std::pair{2, 30}, std::pair{3, 60}}) {
    crowd.join(id, static_cast<std::uint64_t>(cost));
  }
  for (int i = 0; i < 9'000; ++i) ++went[crowd.step()];
  CHECK(went[1] == Approx(6'000).margin(10));
  CHECK(went[2] == Approx(2'000).margin(10));
  CHECK(went[3] == Approx(1'000).margin(10));
}

TEST_CASE("who comes back saves up no turns") {
  Crowd crowd;
  crowd.join(1, 10);
  for (int i = 0; i < 1'000; ++i) crowd.step();
  crowd.join(2, 10);
  int went = 0;
  for (int i = 0; i < 100; ++i) went += crowd.step() == 2 ? 1 : 0;
  CHECK(went == Approx(50).margin(2));
}

TEST_CASE("small pieces of who wants little go before large ones, and wait for one of each of their size") {
  const std::uint64_t cost = GENERATE(1'000, 10);
  Crowd crowd;
  for (int id = 0; id < 100; ++id) crowd.join(id, cost);
  crowd.costs[500] = 10;
  for (int round = 0; round < 50; ++round) {
    for (int i = 0; i < 30; ++i) crowd.step();
    CHECK(crowd.waits(500) <= (cost == 10 ? 101 : 3));
  }
}

TEST_CASE("a large piece waits until the others had as much, also one by one") {
  Crowd crowd;
  for (int id = 0; id < 100; ++id) crowd.join(id, 1'000);
  for (int i = 0; i < 1'000; ++i) crowd.step();
  crowd.costs[600] = 5'000;
  for (int round = 0; round < 3; ++round) CHECK(crowd.waits(600) == Approx(450).margin(151));
  crowd.order.enter(600, 5'000);
  crowd.order.enter(600, 1);  // in its place
  int others = 0;
  while (crowd.step(600) != 600) ++others;
  CHECK(others < 101);
}

TEST_CASE("where nobody is entered nobody goes") {
  FairOrder<int> order;
  CHECK_FALSE(order.next().has_value());
  CHECK_FALSE(order.next_cost().has_value());
  order.enter(1, 7);
  CHECK(order.size() == 1);
  CHECK(order.next_cost() == 7);
  CHECK(order.next() == 1);
  CHECK_FALSE(order.next().has_value());
}
