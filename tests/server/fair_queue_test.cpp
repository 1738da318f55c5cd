#include "limits/flows/fair_queue.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include "failing_allocations.h"

using namespace talus::server;

namespace {

using Flat = FairQueue<int>;
using Flows = FairQueue<int, int>;
using Leaf = std::pair<int, int>;

/// The rule of fair_queue.h for two levels of classes, by searching all entrants.
class PlainQueue {
 public:
  explicit PlainQueue(Flows::Rules rules) : rules_{rules} {}

  void set_share(double share, int flow) { top_.entrants[flow].share = share; }
  void enter(const FairEntry& entry, int flow, int client) {
    Entrant& leaf = below_[flow].entrants[client];
    leaf.offset = entry.offset;
    arrive(below_[flow], leaf, rules_[1]);
    refresh(flow);
    arrive(top_, top_.entrants[flow], rules_[0]);
  }
  void leave(int flow, int client) {
    below_[flow].entrants[client].waits = false;
    refresh(flow);
  }
  void charge(double reserved, double done, int flow, int client) {
    pay(below_[flow], client, reserved, done);
    refresh(flow);
    pay(top_, flow, reserved, done);
  }
  std::optional<Leaf> next(const std::set<Leaf>& blocked, const std::set<Leaf>& idle) {
    std::optional<Leaf> goes;
    std::vector<int> asked;
    for (const int flow : in_order(top_)) {
      if (goes) break;
      Level& level = below_[flow];
      std::vector<int> passed;
      for (const int client : in_order(level)) {
        if (!idle.contains({flow, client}) && !blocked.contains({flow, client})) {
          goes = {flow, client};
          level.went(level.entrants[client]);
          break;
        }
        passed.push_back(client);
        if (idle.contains({flow, client})) level.entrants[client].waits = false;
      }
      if (goes) lose_turn(level, passed, rules_[1]);
      refresh(flow);
      if (goes) {
        top_.went(top_.entrants[flow]);
      } else {
        asked.push_back(flow);
      }
    }
    if (goes) lose_turn(top_, asked, rules_[0]);
    return goes;
  }

 private:
  struct Entrant {
    double clock = 0;
    double lead = 0;
    double ahead_until = 0;
    double share = 1;
    double offset = 0;
    bool waits = false;
    [[nodiscard]] double ahead() const { return clock < ahead_until ? lead : 0; }
    [[nodiscard]] double order() const { return clock - ahead() + offset / share; }
  };
  struct Level {
    std::map<int, Entrant> entrants;
    double now = 0;
    double overtaking = 0;
    double dearest = 0;
    void went(const Entrant& entrant) {
      const double clock = entrant.clock - entrant.ahead() + std::min(0.0, entrant.offset / entrant.share);
      if (clock <= now) return;
      overtaking = std::max(0.0, overtaking - 2 * (clock - now));
      now = clock;
    }
    void arrives(Entrant& entrant, const FairRule& rule) const {
      const double start = now + std::max(0.0, overtaking - dearest - rule.lead - rule.saved);
      if (entrant.clock > start) return;
      entrant.clock = std::max(entrant.clock, start - rule.saved);
      entrant.lead = rule.lead;
      entrant.ahead_until = entrant.clock + rule.lead;
    }
  };

  static void arrive(Level& level, Entrant& entrant, const FairRule& rule) {
    if (entrant.waits) return;
    level.arrives(entrant, rule);
    entrant.waits = true;
  }
  static void lose_turn(Level& level, const std::vector<int>& asked, const FairRule& rule) {
    for (const int id : asked) {
      Entrant& entrant = level.entrants[id];
      if (entrant.waits) level.arrives(entrant, rule);
    }
  }
  static void pay(Level& level, int id, double reserved, double done) {
    Entrant& payer = level.entrants[id];
    double shares = payer.waits ? 0 : payer.share;
    for (const auto& [other, entrant] : level.entrants) shares += entrant.waits ? entrant.share : 0;
    payer.clock += (reserved + done) / payer.share;
    level.overtaking += done / shares;
    level.dearest = std::max(level.dearest, done / payer.share);
  }
  static std::vector<int> in_order(const Level& level) {
    std::vector<int> ids;
    for (const auto& [id, entrant] : level.entrants) {
      if (entrant.waits) ids.push_back(id);
    }
    std::stable_sort(ids.begin(), ids.end(), [&](int a, int b) {
      return level.entrants.at(a).order() < level.entrants.at(b).order();
    });
    return ids;
  }
  /// A flow waits while a client does; its clients are classes, and it goes as far ahead as one of them may.
  void refresh(int flow) {
    const auto clients = in_order(below_[flow]);
    Entrant& entrant = top_.entrants[flow];
    if (clients.empty()) {
      entrant.waits = false;
      return;
    }
    entrant.offset = below_[flow].entrants[clients.front()].offset;
    for (const int client : clients) {
      entrant.offset = std::min(entrant.offset, below_[flow].entrants[client].offset);
    }
  }

  Flows::Rules rules_;
  Level top_;
  std::map<int, Level> below_;
};

/// Entrants of one level that have a piece at once after each, but those that `seldom` names.
struct Crowd {
  explicit Crowd(bool costs_known = false, double lead = 0) : queue{{FairRule{lead}}}, known{costs_known} {}

  Flat queue;
  bool known;  // each cost before its piece
  std::map<int, double> costs;
  std::map<int, double> spent;
  int seldom = -1;

  void enter(int id) { queue.enter({.offset = known ? costs.at(id) : 0}, id); }
  void join(int id, double cost) {
    costs[id] = cost;
    enter(id);
  }
  int step() {
    const auto next = queue.next();
    REQUIRE(next.has_value());
    const int id = std::get<0>(*next);
    if (id == seldom) queue.leave(id);
    queue.charge(costs.at(id), id);
    spent[id] += costs.at(id);
    return id;
  }
  /// Returns the cost of others that go before `id`, which comes now.
  double waits(int id) {
    enter(id);
    seldom = id;
    double others = 0;
    for (int next = step(); next != id; next = step()) others += costs.at(next);
    return others;
  }
};

/// The least and the greatest value of what two have used, one less the other: over any interval what they
/// use differs by at most `range()`.
struct Difference {
  double least = 0;
  double most = 0;
  void add(double difference) {
    least = std::min(least, difference);
    most = std::max(most, difference);
  }
  [[nodiscard]] double range() const { return most - least; }
};

constexpr double kRounding = 1e-6;

}  // namespace

TEST_CASE("the queue does what its rule says") {
  CHECK(rc::check([] {
    constexpr int kIds = 5;
    const auto amount = rc::gen::element(0.0, 10.0, 100.0);
    const Flows::Rules rules{FairRule{*amount, *amount}, FairRule{*amount, *amount}};
    FairQueue<Classes<int, kIds>, Classes<int, kIds>> queue{rules};
    PlainQueue plain{rules};
    for (int flow = 0; flow < kIds; ++flow) {
      const double share = *rc::gen::element(1.0, 2.0, 5.0);
      queue.set_share(share, flow);
      plain.set_share(share, flow);
    }
    const auto leaf = rc::gen::pair(rc::gen::inRange(0, kIds), rc::gen::inRange(0, kIds));
    const int steps = *rc::gen::inRange(1, 300);
    for (int step = 0; step < steps; ++step) {
      const auto [flow, client] = *leaf;
      const double cost = *rc::gen::inRange(0, 100);
      switch (*rc::gen::inRange(0, 8)) {
        case 0:
        case 1:
        case 2: {
          const FairEntry entry{*rc::gen::element(0.0, cost, -50.0)};
          queue.enter(entry, flow, client);
          plain.enter(entry, flow, client);
          break;
        }
        case 3:
          queue.leave(flow, client);
          plain.leave(flow, client);
          break;
        default: {
          const auto blocked =
              *rc::gen::container<std::set<Leaf>>(*rc::gen::inRange<std::size_t>(0, 4), leaf);
          const auto idle = *rc::gen::container<std::set<Leaf>>(*rc::gen::inRange<std::size_t>(0, 3), leaf);
          const auto next = queue.next([&](int of, int which) {
            if (idle.contains({of, which})) return FairState::idle;
            return blocked.contains({of, which}) ? FairState::blocked : FairState::ready;
          });
          const auto expected = plain.next(blocked, idle);
          RC_ASSERT(next.has_value() == expected.has_value());
          if (!next) break;
          RC_ASSERT(std::get<0>(*next) == expected->first);
          RC_ASSERT(std::get<1>(*next) == expected->second);
          const double estimate = *rc::gen::inRange(0, 100);
          queue.reserve(estimate, expected->first, expected->second);
          plain.charge(estimate, 0, expected->first, expected->second);
          queue.reserve(-estimate, expected->first, expected->second);
          plain.charge(-estimate, 0, expected->first, expected->second);
          queue.charge(cost, expected->first, expected->second);
          plain.charge(0, cost, expected->first, expected->second);
        }
      }
    }
  }));
}

TEST_CASE("over any time in which two always have work what they use differs by a piece of each") {
  CHECK(rc::check([] {
    const double lead = *rc::gen::element(0.0, 0.0, 500.0);
    const double saved = *rc::gen::element(0.0, 0.0, 700.0);
    const bool known = *rc::gen::arbitrary<bool>();
    Flat queue{{FairRule{lead, saved}}};
    const int entrants = *rc::gen::inRange(2, 8);
    std::vector<double> shares;
    std::vector<double> dearest;
    std::vector<double> costs(static_cast<std::size_t>(entrants));
    for (int id = 0; id < entrants; ++id) {
      shares.push_back(*rc::gen::inRange(1, 5));
      dearest.push_back(*rc::gen::inRange(1, 1000));
      queue.set_share(shares.back(), id);
    }
    const auto enter = [&](std::size_t id) {
      costs[id] = *rc::gen::inRange(1, static_cast<int>(dearest[id]) + 1);
      queue.enter({.offset = known ? costs[id] : 0}, static_cast<int>(id));
    };
    // 0 and 1 always have work, 1 since a while later; the others come and go.
    enter(0);
    std::vector<double> used(2);
    Difference difference;
    const int late = *rc::gen::inRange(0, 100);
    for (int piece = 0; piece < 400; ++piece) {
      if (piece == late) {
        enter(1);
        used = {0, 0};
      }
      if (entrants > 2) {
        const int other = *rc::gen::inRange(2, entrants);
        *rc::gen::arbitrary<bool>() ? enter(static_cast<std::size_t>(other)) : queue.leave(other);
      }
      const auto next = queue.next();
      RC_ASSERT(next.has_value());
      const auto id = static_cast<std::size_t>(std::get<0>(*next));
      const double cost = costs[id];
      queue.charge(cost, static_cast<int>(id));
      enter(id);
      if (id > 1 || piece < late) continue;
      used[id] += cost / shares[id];
      difference.add(used[0] - used[1]);
    }
    const double first = dearest[0] / shares[0];
    const double second = dearest[1] / shares[1];
    const double offset = known ? std::max(first, second) : 0;
    RC_ASSERT(difference.range() <= first + second + offset + lead + saved + kRounding);
  }));
}

TEST_CASE("a flow of many clients gets one flow's share, and its clients share it") {
  CHECK(rc::check([] {
    Flows queue;
    const std::vector<int> clients{1, *rc::gen::inRange(2, 20)};
    const std::vector<double> dearest{static_cast<double>(*rc::gen::inRange(1, 500)),
                                      static_cast<double>(*rc::gen::inRange(1, 500))};
    const double share = *rc::gen::element(1.0, 3.0);
    queue.set_share(share, 1);
    for (int flow = 0; flow < 2; ++flow) {
      for (int client = 0; client < clients[static_cast<std::size_t>(flow)]; ++client)
        queue.enter({}, flow, client);
    }
    std::vector<double> of_flow(2);
    std::map<int, double> of_client;
    Difference flows;
    Difference pair;
    for (int piece = 0; piece < 500; ++piece) {
      const auto [flow, client] = *queue.next();
      const auto number = static_cast<std::size_t>(flow);
      const double cost = *rc::gen::inRange(1, static_cast<int>(dearest[number]) + 1);
      queue.charge(cost, flow, client);
      of_flow[number] += cost / (flow == 1 ? share : 1);
      if (flow == 1) of_client[client] += cost;
      flows.add(of_flow[0] - of_flow[1]);
      pair.add(of_client[0] - of_client[1]);
    }
    RC_ASSERT(flows.range() <= dearest[0] + dearest[1] / share + kRounding);
    RC_ASSERT(pair.range() <= 2 * dearest[1] + kRounding);
  }));
}

TEST_CASE("an entry goes within a bound, though new entrants arrive without end") {
  CHECK(rc::check([] {
    const double lead = *rc::gen::element(0.0, 300.0);
    const double saved = *rc::gen::element(0.0, 300.0);
    const double dearest = *rc::gen::inRange(1, 500);
    const int at_once = *rc::gen::inRange(1, 6);
    Flat queue{{FairRule{lead, saved}}};
    queue.enter({}, 0);
    const bool owes = *rc::gen::arbitrary<bool>();
    if (owes) queue.charge(dearest, 0);
    int newest = 0;
    double others = 0;
    for (;;) {
      for (int i = 0; i < at_once; ++i) queue.enter({}, ++newest);
      const int goes = std::get<0>(*queue.next());
      if (goes == 0) break;
      const double cost = *rc::gen::inRange(1, static_cast<int>(dearest) + 1);
      queue.charge(cost, goes);
      queue.leave(goes);
      for (int id = std::max(1, newest - 10); id <= newest; ++id) queue.leave(id);
      others += cost;
      // All shares together, for as long as now has to go, and the last piece.
      RC_ASSERT(others <= (at_once + 1) * (3 * (lead + saved) + 5 * dearest));
    }
  }));
}

TEST_CASE("if any allocation fails during an entry, the queue is unchanged") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    Flows queue{{FairRule{5}, FairRule{5}}};
    for (int id = 0; id < 8; ++id) queue.enter({}, id % 2, id);
    const int flow = GENERATE(1, 2);
    {
      const talus::test::FailingAllocations failing{allocations};
      try {
        queue.enter({}, flow, 100);
      } catch (const std::bad_alloc&) {
      }
      failed = failing.has_failed();
    }
    std::vector<int> order;
    while (const auto next = queue.next()) {
      order.push_back(std::get<1>(*next));
      std::apply([&](auto... ids) { queue.leave(ids...); }, *next);
    }
    CHECK(order.size() == (failed ? 8U : 9U));
    std::erase(order, 100);
    CHECK(order == std::vector{0, 2, 4, 6, 1, 3, 5, 7});
    CHECK(queue.empty());
  }
}

TEST_CASE("entering and taking again and again allocates nothing") {
  Flows queue{{FairRule{5}, FairRule{5}}};
  for (int id = 0; id < 20; ++id) queue.enter({}, id % 3, id);
  const talus::test::FailingAllocations failing{0};
  for (int i = 0; i < 1000; ++i) {
    const auto [flow, client] = *queue.next();
    queue.charge(i % 7, flow, client);
    queue.leave(flow, client);
    queue.enter({}, flow, client);
  }
  CHECK_FALSE(failing.has_failed());
}

TEST_CASE("entrants share by cost, whether it is known before or charged afterwards") {
  Crowd crowd{GENERATE(true, false)};
  crowd.join(1, 10);
  crowd.join(2, 30);
  crowd.join(3, 60);
  for (int i = 0; i < 9'000; ++i) crowd.step();
  for (const auto& [id, spent] : crowd.spent) CHECK(spent == Approx(60'000).margin(100));
}

TEST_CASE("equal entrants go by turns") {
  Crowd crowd;
  for (int id = 0; id < 4; ++id) crowd.join(id, 10);
  std::vector<int> order;
  for (int i = 0; i < 8; ++i) order.push_back(crowd.step());
  CHECK(order == std::vector{0, 1, 2, 3, 0, 1, 2, 3});
}

TEST_CASE("a piece that was dear is paid off, also by an entrant that left meanwhile") {
  Crowd crowd;
  crowd.join(1, 400);
  crowd.join(2, 100);
  std::vector<int> order;
  for (int piece = 0; piece < 3; ++piece) order.push_back(crowd.step());
  crowd.queue.leave(1);
  crowd.enter(1);
  for (int piece = 0; piece < 4; ++piece) order.push_back(crowd.step());
  CHECK(order == std::vector{1, 2, 2, 2, 2, 1, 2});
}

TEST_CASE("an entrant that comes, or comes back, goes first for its lead, and has no more in all") {
  const double lead = GENERATE(0, 50);
  Crowd crowd{false, lead};
  crowd.join(1, 10);
  for (int i = 0; i < 1'000; ++i) crowd.step();
  crowd.join(2, 10);
  int first = 0;
  while (crowd.step() == 2) ++first;
  CHECK(first >= lead / 10);
  CHECK(first <= lead / 10 + 1);
  for (int i = first + 1; i < 100; ++i) crowd.step();
  CHECK(crowd.spent[2] == Approx(500).margin(20));
  // Within what it may have anyway it gains no turns by going and coming back.
  crowd.spent.clear();
  for (int i = 0; i < 100; ++i) {
    crowd.queue.leave(2);
    crowd.enter(2);
    crowd.step();
  }
  CHECK(crowd.spent[2] == Approx(500).margin(20));
}

TEST_CASE(
    "small pieces of an entrant that wants little go before large ones, and wait for few of their size") {
  const bool known = GENERATE(true, false);
  const double cost = GENERATE(1'000, 10);
  Crowd crowd{known, known || cost == 10 ? 0.0 : 50.0};
  for (int id = 0; id < 100; ++id) crowd.join(id, cost);
  crowd.costs[500] = 10;
  for (int i = 0; i < 100; ++i) crowd.step();
  for (int round = 0; round < 50; ++round) {
    for (int i = 0; i < 30; ++i) crowd.step();
    CHECK(crowd.waits(500) <= (cost == 10 ? 101 * cost : 3 * cost));
  }
}

TEST_CASE("a large piece of known cost waits until the others had as much, also one by one") {
  Crowd crowd{true};
  for (int id = 0; id < 100; ++id) crowd.join(id, 1'000);
  for (int i = 0; i < 1'000; ++i) crowd.step();
  crowd.costs[600] = 5'000;
  for (int round = 0; round < 3; ++round) CHECK(crowd.waits(600) == Approx(450'000).margin(151'000));
  crowd.enter(600);
  crowd.queue.enter({.offset = 1}, 600);  // in its place
  int others = 0;
  while (crowd.step() != 600) ++others;
  CHECK(others < 101);
}

TEST_CASE(
    "an entrant with an offset goes first until it is that far ahead, and pays for it when it returns") {
  FairQueue<Classes<int, 2>> queue;
  const auto step = [&] {
    const int id = std::get<0>(*queue.next());
    queue.charge(10, id);
    return id;
  };
  queue.enter({.offset = -50}, 1);
  queue.enter({}, 0);
  std::vector<int> order;
  for (int i = 0; i < 9; ++i) order.push_back(step());
  CHECK(order == std::vector{1, 1, 1, 1, 1, 0, 1, 0, 1});
  queue.leave(1);
  for (int i = 0; i < 2; ++i) CHECK(step() == 0);
  queue.enter({.offset = -50}, 1);
  order.clear();
  for (int i = 0; i < 4; ++i) order.push_back(step());
  CHECK(order == std::vector{1, 1, 0, 1});
}

TEST_CASE("an entrant below with an offset puts all that is above it as far ahead, and no farther") {
  FairQueue<int, int, Classes<int, 2, 3>> queue;
  queue.enter({}, 1, 11, 1);
  queue.enter({}, 2, 21, 1);
  queue.enter({}, 2, 22, 1);
  queue.enter({.offset = -50}, 2, 22, 0);
  std::vector<int> flows;
  std::map<int, double> spent;
  for (int piece = 0; piece < 400; ++piece) {
    const auto [flow, client, number] = *queue.next();
    if (piece < 8) flows.push_back(flow);
    queue.charge(10, flow, client, number);
    spent[flow] += 10;
    spent[client] += 10;
    spent[number - 100] += client == 22 ? 10 : 0;
  }
  CHECK(std::vector(flows.begin(), flows.begin() + 5) == std::vector{2, 2, 2, 2, 2});
  CHECK(spent[2] - spent[1] == Approx(0).margin(60));
  CHECK(spent[22] - spent[21] == Approx(0).margin(60));
  CHECK(spent[0 - 100] - 3 * spent[1 - 100] == Approx(0).margin(160));
}

TEST_CASE("classes share by their shares, and of two that could go the first goes") {
  FairQueue<Classes<int, 2>, int> queue{{FairRule{0, GENERATE(0.0, 640.0)}, FairRule{}}};
  queue.set_share(3, 0);
  for (int id = 10; id > 0; --id) queue.enter({}, id == 10 ? 1 : 0, id);
  std::vector<double> spent(2);
  const double cost = GENERATE(10, 100, 250);
  for (int piece = 0; piece < 4000; ++piece) {
    const auto [number, id] = *queue.next();
    if (piece == 0) CHECK(number == 0);
    queue.charge(cost, number, id);
    spent[static_cast<std::size_t>(number)] += cost;
  }
  CHECK(std::abs(spent[0] - 3 * spent[1]) <= 4 * cost);
}

TEST_CASE("an entrant that has all the time while it is alone owes little for it when others come") {
  FairQueue<Classes<int, 2>> queue{{FairRule{0, 640}}};
  queue.set_share(3, 0);
  const int first = GENERATE(0, 1);
  std::vector<double> spent(2);
  const auto step = [&] {
    const int id = std::get<0>(*queue.next());
    queue.charge(100, id);
    spent[static_cast<std::size_t>(id)] += 100;
  };
  queue.enter({}, first);
  for (int i = 0; i < 1000; ++i) step();
  CHECK(spent[static_cast<std::size_t>(first)] == 100'000);
  spent = {0, 0};
  queue.enter({}, 1 - first);
  for (int i = 0; i < 4000; ++i) step();
  CHECK(spent[0] == Approx(300'000).margin(2 * 640));
}

TEST_CASE("a blocked entrant is passed over, and comes back as if it were new") {
  Flat queue{{FairRule{20}}};
  queue.enter({}, 1);
  queue.enter({}, 2);
  const auto step = [&](int blocked) {
    const auto next =
        queue.next([&](int id) { return id == blocked ? FairState::blocked : FairState::ready; });
    queue.charge(10, std::get<0>(*next));
    return std::get<0>(*next);
  };
  for (int i = 0; i < 100; ++i) CHECK(step(1) == 2);
  int before = 0;
  while (step(0) == 1) ++before;
  CHECK(before >= 2);
  CHECK(before <= 5);
}

TEST_CASE("a blocked flow blocks all its clients, which are not asked") {
  struct Ready {
    int asked = 0;
    FairState operator()(int flow) const { return flow == 1 ? FairState::blocked : FairState::ready; }
    FairState operator()(int /*flow*/, int /*client*/) {
      ++asked;
      return FairState::ready;
    }
  } ready;
  Flows queue;
  for (int client = 0; client < 10; ++client) queue.enter({}, 1, client);
  CHECK_FALSE(queue.next(ready).has_value());
  CHECK(ready.asked == 0);
  queue.enter({}, 2, 50);
  CHECK(queue.next(ready) == Flows::Path{2, 50});
  CHECK(ready.asked == 1);
}

TEST_CASE("an empty queue gives nothing, and a cleared one owes nothing") {
  Flows queue;
  CHECK_FALSE(queue.next().has_value());
  queue.leave(1, 1);
  queue.charge(7, 1, 1);
  queue.enter({}, 1, 1);
  queue.enter({}, 2, 2);
  queue.charge(1000, 1, 1);
  queue.clear();
  CHECK(queue.empty());
  queue.enter({}, 1, 1);
  queue.enter({}, 2, 2);
  CHECK(queue.next() == Flows::Path{1, 1});
  queue.leave(2, 2);
  CHECK_FALSE(queue.empty());
  CHECK_FALSE(queue.next([](int, int) { return FairState::idle; }).has_value());
  CHECK(queue.empty());
}
