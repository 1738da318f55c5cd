#include "limits/flows/heavy_hitters.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <deque>
#include <map>
#include <new>
#include <vector>

#include <rapidcheck.h>

#include "failing_allocations.h"

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

FlowUse flow(std::uint64_t id) {
  return {FlowId{id}, FlowName{FlowName::Kind::address, std::to_string(id)}};
}

void use(HeavyHitters& hitters, std::uint64_t id, std::uint64_t amount) {
  hitters.add(flow(id), amount);
}

std::vector<std::string> names(const std::vector<FlowFigures>& top) {
  std::vector<std::string> names;
  for (const FlowFigures& each : top) names.push_back(each.name->text);
  return names;
}

}  // namespace

TEST_CASE("a steady use is its rate, and falls as load averages do") {
  HeavyHitters hitters{4};
  for (int second = 0; second < 1000; ++second) {
    hitters.pass(1s);
    use(hitters, 1, 100);
  }
  const FlowFigures steady = hitters.top(1).at(0);
  CHECK(steady.in_ten_seconds == Approx(100).epsilon(1e-6));
  CHECK(steady.in_a_minute == Approx(100).epsilon(1e-6));
  CHECK(steady.total == 100'000);
  hitters.pass(10s);
  CHECK(hitters.top(1).at(0).in_ten_seconds == Approx(100 * std::exp(-1)).epsilon(1e-6));
  hitters.pass(50s);
  CHECK(hitters.top(1).at(0).in_a_minute == Approx(100 * std::exp(-1)).epsilon(1e-6));
  CHECK(hitters.all().in_a_minute == Approx(100 * std::exp(-1)).epsilon(1e-6));
}

TEST_CASE("a flow that uses little each time, and often, is listed in the end, though it was cut off") {
  constexpr std::uint64_t kEntries = 4;
  HeavyHitters hitters{kEntries};
  for (std::uint64_t once = 1; once <= kEntries; ++once) use(hitters, once, 100);
  for (std::uint64_t stranger = 1000; stranger < 1050; ++stranger) {
    use(hitters, 99, 10);
    use(hitters, stranger, 11);  // more at a time, and never again
    hitters.cut();
  }
  const auto listed = names(hitters.top(kEntries));
  CHECK(std::find(listed.begin(), listed.end(), "99") != listed.end());
}

TEST_CASE("a flow's possible use long ago does not keep it listed") {
  HeavyHitters hitters{2};
  for (std::uint64_t id = 1; id <= 3; ++id) use(hitters, id, 1'000'000);
  hitters.cut();
  use(hitters, 4, 1);  // may have used a million before
  use(hitters, 5, 1);
  hitters.cut();
  hitters.pass(10min);
  use(hitters, 6, 1000);
  use(hitters, 7, 1000);
  hitters.cut();
  auto listed = names(hitters.top(2));
  std::sort(listed.begin(), listed.end());
  CHECK(listed == std::vector<std::string>{"6", "7"});
}

TEST_CASE("the heaviest of many flows stay, in any order of arrival") {
  // Few use much, many use little, and each little one comes once: what a table that forgets what it cuts
  // off, or that favours who came last, does not survive.
  REQUIRE(rc::check("the heaviest flows are listed, and none is overestimated", [] {
    constexpr std::size_t kEntries = 16;
    HeavyHitters hitters{kEntries};
    std::map<std::uint64_t, double> used;
    double all = 0;
    std::uint64_t stranger = 1000;
    const auto seconds = *rc::gen::inRange(1, 60);
    for (int second = 0; second < seconds; ++second) {
      hitters.pass(1s);
      const double left = std::exp(-1.0 / 60);
      all *= left;
      for (auto& [id, amount] : used) amount *= left;
      for (int batch = *rc::gen::inRange(0, 4); batch > 0; --batch) {
        const auto count = *rc::gen::inRange(0, 60);
        for (int i = 0; i < count; ++i) {
          const bool heavy = *rc::gen::inRange(0, 3) == 0;
          const std::uint64_t id = heavy ? *rc::gen::inRange<std::uint64_t>(0, 8) : ++stranger;
          const auto amount = *rc::gen::inRange<std::uint64_t>(1, heavy ? 100 : 10);
          use(hitters, id, amount);
          used[id] += static_cast<double>(amount);
          all += static_cast<double>(amount);
        }
        hitters.cut();
        RC_ASSERT(hitters.size() <= kEntries);
      }
    }
    const double to_rate = 1 - std::exp(-1.0 / 60);
    const auto top = hitters.top(kEntries);
    const auto listed = names(top);
    for (const auto& [id, amount] : used) {
      if (amount > all / (kEntries + 1) * (1 + 1e-9)) {
        RC_ASSERT(std::find(listed.begin(), listed.end(), std::to_string(id)) != listed.end());
      }
    }
    for (const FlowFigures& each : top) {
      const double really = used.at(std::stoull(each.name->text)) * to_rate;
      RC_ASSERT(each.in_a_minute <= really * (1 + 1e-9));
      RC_ASSERT(each.in_a_minute >= really - all / (kEntries + 1) * to_rate - 1e-9);
    }
    RC_ASSERT(std::abs(hitters.all().in_a_minute - all * to_rate) <= 1e-6 * all);
  }));
}

TEST_CASE("the ten heaviest of a skewed stream of 100,000 flows are the ten shown, in order") {
  HeavyHitters hitters{1024};
  // The k-th flow uses 2,000,000 / k (Zipf), in ten rounds, the light ones last.
  for (int round = 0; round < 10; ++round) {
    hitters.pass(1s);
    for (std::uint64_t k = 1; k <= 100'000; ++k) use(hitters, k, 200'000 / k + 1);
    hitters.cut();
    REQUIRE(hitters.size() == 1024);
  }
  CHECK(names(hitters.top(10)) ==
        std::vector<std::string>{"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"});
}

TEST_CASE("if any allocation fails while flows are added and cut, each keeps its own figures") {
  constexpr std::uint64_t kFlows = 12;
  std::deque<FlowUse> flows;
  for (std::uint64_t id = 1; id <= kFlows; ++id) {
    flows.emplace_back(FlowId{id}, FlowName{FlowName::Kind::address, std::to_string(id)});
  }
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    HeavyHitters hitters{kFlows};
    std::size_t added = 0;
    {
      const talus::test::FailingAllocations failing{allocations};
      try {
        for (; added < kFlows; ++added) hitters.add(flows[added], 100);
      } catch (const std::bad_alloc&) {
      }
      failed = failing.has_failed();
    }
    // Those that are missing, the one that failed last.
    for (std::size_t flow = kFlows; flow-- > added;) hitters.add(flows[flow], 100);
    const auto top = hitters.top(kFlows);
    CHECK(top.size() == kFlows);
    for (const FlowFigures& each : top) CHECK(each.total == 100);
    CHECK(hitters.all().total == 100 * kFlows);
  }
}

TEST_CASE("a cut allocates nothing, and flows that stay keep their places") {
  HeavyHitters hitters{3};
  for (std::uint64_t id = 1; id <= 9; ++id) use(hitters, id, 10 * id);
  {
    const talus::test::FailingAllocations failing{0};
    REQUIRE_NOTHROW(hitters.cut());
  }
  for (const std::uint64_t id : {9, 8, 7}) use(hitters, id, 1000 * id);
  const auto top = hitters.top(3);
  CHECK(names(top) == std::vector<std::string>{"9", "8", "7"});
  for (std::uint64_t place = 0; place < 3; ++place) CHECK(top[place].total == 1010 * (9 - place));
}
