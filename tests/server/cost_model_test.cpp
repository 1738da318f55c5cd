#include "chunks/generation/cost_model.h"

#include <catch2/catch.hpp>

#include "chunks/generation/recent_flows.h"

using namespace talus::server;
using namespace std::chrono_literals;

TEST_CASE(
    "before any was measured, a patch is guessed to cost more than a chunk, and a chunk than a height") {
  const WorkCosts guessed = CostModel{}.costs();
  CHECK(guessed.patch > guessed.chunk);
  CHECK(guessed.chunk > guessed.height);
  CHECK(guessed.height > 0);
}

TEST_CASE("costs are the means of what was measured, each kind by itself") {
  CostModel model;
  MeasuredWork work;
  work.patch_time = 3ms;
  work.patches = 1;
  work.chunk_time = 100us;
  work.chunks = 8;
  model.add(work);
  work.patch_time = 1ms;
  work.chunk_time = 60us;
  model.add(work);
  CHECK(model.costs().patch == 2'000'000);
  CHECK(model.costs().chunk == 10'000);
  CHECK(model.costs().height == CostModel{}.costs().height);
}

TEST_CASE("nothing costs nothing") {
  CostModel model;
  MeasuredWork work;
  work.patches = work.chunks = work.heights = 1000;
  model.add(work);
  CHECK(model.costs().patch == 1);
  CHECK(model.costs().chunk == 1);
  CHECK(model.costs().height == 1);
}

TEST_CASE("one flow that asks again and again is alone") {
  RecentFlows flows;
  Clock::time_point now{1h};
  for (int i = 0; i < 5; ++i) flows.asked(FlowId{7}, now += 100ms);
  CHECK_FALSE(flows.several(now));
}

TEST_CASE("two that ask within a second of each other are several, until a second later") {
  RecentFlows flows;
  const Clock::time_point start{1h};
  flows.asked(FlowId{7}, start);
  flows.asked(FlowId{8}, start + 999ms);
  CHECK(flows.several(start + 1999ms));
  CHECK_FALSE(flows.several(start + 2001ms));
}

TEST_CASE("two that ask long after each other are each alone") {
  RecentFlows flows;
  const Clock::time_point start{1h};
  flows.asked(FlowId{7}, start);
  flows.asked(FlowId{8}, start + 1s);
  CHECK_FALSE(flows.several(start + 1s));
}
