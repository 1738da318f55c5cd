#include "limits/flows/flow_uses.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <memory>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "failing_allocations.h"

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

const std::vector<unsigned char> kAddress{192, 0, 2, 1};

std::uint64_t total(const FlowUses& flows, FlowMeasure measure) {
  return flows.top(1)[static_cast<std::size_t>(measure)].all.total;
}

}  // namespace

TEST_CASE("sessions of a flow add to one use, and another flow has its own") {
  FlowUses flows;
  const FlowUsePtr one = flows.of_address(kAddress, "192.0.2.1");
  CHECK(flows.of_address(kAddress, "192.0.2.1") == one);
  CHECK(flows.of_subject("alice") != one);
  CHECK(one->id() == flows.ids().of_address(kAddress));
  CHECK(one->name()->text == "192.0.2.1");
}

TEST_CASE("each measure has its own top") {
  FlowUses flows;
  const FlowUsePtr one = flows.of_address(kAddress, "192.0.2.1");
  const FlowUsePtr alice = flows.of_subject("alice");
  one->add(FlowMeasure::sent, 10);
  alice->add(FlowMeasure::sent, 20);
  one->add(FlowMeasure::generator, 7);
  alice->add(FlowMeasure::refusals, 3);
  flows.collect(Clock::time_point{1s});
  const auto top = flows.top(1);
  CHECK(top[0].top.at(0).name->text == "192.0.2.1");
  CHECK(top[0].top.at(0).total == 7);
  CHECK(top[1].top.at(0).name->text == "alice");
  CHECK(top[1].top.at(0).name->kind == FlowName::Kind::subject);
  CHECK(top[1].all.total == 30);
  CHECK(flows.refusals() == 3);
}

TEST_CASE("a flow's use before it leaves counts, and then it is forgotten") {
  FlowUses flows;
  auto leaving = flows.of_address(kAddress, "192.0.2.1");
  flows.collect(Clock::time_point{1s});
  leaving->add(FlowMeasure::sent, 5);
  leaving.reset();
  CHECK(flows.flows() == 1);
  flows.collect(Clock::time_point{2s});
  flows.collect(Clock::time_point{3s});
  CHECK(flows.flows() == 0);
  CHECK(total(flows, FlowMeasure::sent) == 5);
}

TEST_CASE("a flow that returns between two collections stays the same") {
  FlowUses flows;
  const std::weak_ptr<FlowUse> alice = flows.of_subject("alice");
  flows.collect(Clock::time_point{1s});
  REQUIRE_FALSE(alice.expired());
  // It adds at the very moment at which the next look finds that it has left: the one after it counts that.
  flows.of_subject("alice")->add(FlowMeasure::sent, 1);
  flows.collect(Clock::time_point{2s});
  REQUIRE_FALSE(alice.expired());
  const FlowUsePtr back = flows.of_subject("alice");
  CHECK(back == alice.lock());
  flows.collect(Clock::time_point{3s});
  flows.collect(Clock::time_point{4s});
  CHECK(flows.of_subject("alice") == back);
}

TEST_CASE("a flood of flows that come once takes no more memory than flows that stay") {
  FlowUses flows;
  for (int flow = 0; flow < 200'000; ++flow) {
    flows.of_subject(std::to_string(flow))->add(FlowMeasure::refusals, 1);
    REQUIRE(flows.flows() <= 4096);
  }
  flows.collect(Clock::time_point{1s});
  CHECK(flows.refusals() == 200'000);
}

TEST_CASE("nothing is lost while threads add, come and go") {
  FlowUses flows;
  constexpr std::uint64_t kEach = 20'000;
  std::vector<std::thread> threads;
  std::atomic<int> running = 4;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] {
      for (std::uint64_t n = 0; n < kEach; ++n) {
        flows.of_subject(std::to_string((n + static_cast<std::uint64_t>(i)) % 7))->add(FlowMeasure::sent, 1);
      }
      --running;
    });
  }
  Clock::time_point now{};
  while (running > 0) flows.collect(now += 1s);
  for (auto& thread : threads) thread.join();
  flows.collect(now += 1s);
  CHECK(total(flows, FlowMeasure::sent) == 4 * kEach);
}

TEST_CASE("a long name is cut, and says so") {
  FlowUses flows;
  for (const std::size_t bytes : {FlowName::kMaxBytes, FlowName::kMaxBytes + 1}) {
    const FlowUsePtr flow = flows.of_subject(std::string(bytes, 'x'));
    CHECK(flow->name()->text.size() == FlowName::kMaxBytes);
    CHECK(flow->name()->cut == (bytes > FlowName::kMaxBytes));
  }
}

TEST_CASE("if any allocation fails during collection, the next collection has the rest") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    FlowUses flows;
    std::vector<FlowUsePtr> uses;
    for (int flow = 0; flow < 5; ++flow) {
      uses.push_back(flows.of_subject(std::to_string(flow)));
      uses.back()->add(FlowMeasure::sent, 1);
      uses.back()->add(FlowMeasure::refusals, 2);
    }
    {
      const talus::test::FailingAllocations failing{allocations};
      try {
        flows.collect(Clock::time_point{1s});
      } catch (const std::bad_alloc&) {
      }
      failed = failing.has_failed();
    }
    flows.collect(Clock::time_point{2s});
    CHECK(total(flows, FlowMeasure::sent) == 5);
    CHECK(flows.refusals() == 10);
  }
}
