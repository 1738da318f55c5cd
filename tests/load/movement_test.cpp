#include "movement.h"

#include <rapidcheck/catch.h>
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

using namespace talus::load;

namespace {

MotionPlan plan_of(Role model, double speed = 20) {
  return {model, {1000, 50, -2000}, 0.5, speed, 5, nullptr};
}

}  // namespace

TEST_CASE("one seed is one way") {
  rc::prop("for every model, at any times", [] {
    const auto model = static_cast<Role>(*rc::gen::inRange(0, 5));
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    auto one = make_motion(plan_of(model), Random{seed, 3});
    auto other = make_motion(plan_of(model), Random{seed, 3});
    double seconds = 0;
    for (int step = 0; step < 20; ++step) {
      seconds += *rc::gen::inRange(1, 4000) / 1000.0;
      if (step % 3 == 0) RC_ASSERT(one->at(seconds).place == other->at(seconds).place);
    }
    // However often it is looked at in between.
    RC_ASSERT(glm::length(one->at(seconds).place - other->at(seconds).place) < 1e-6);
  });
}

TEST_CASE("a player is never faster than its speed, except by jumping") {
  for (const Role model : {Role::stand, Role::walk, Role::fly, Role::swarm, Role::slow}) {
    CAPTURE(name_of(model));
    auto motion = make_motion(plan_of(model, 20), Random{7, 1});
    glm::dvec3 before = motion->at(0).place;
    for (int tick = 1; tick < 2000; ++tick) {
      const glm::dvec3 place = motion->at(tick * 0.1).place;
      REQUIRE(glm::length(place - before) <= 2.0 + 1e-9);
      before = place;
    }
  }
}

TEST_CASE("a flight leads straight on") {
  auto motion = make_motion(plan_of(Role::fly, 20), Random{7, 1});
  const glm::dvec3 start = motion->at(0).place;
  CHECK(glm::length(motion->at(60).place - start) == Approx(1200));
}

TEST_CASE("a teleporter moves after its stay, and stays at its new place") {
  auto motion = make_motion(plan_of(Role::teleport), Random{7, 1});
  const glm::dvec3 first = motion->at(6).place;
  CHECK(motion->at(6.0001).place == first);
  CHECK(glm::length(motion->at(11.01).place - first) > 100);
}

TEST_CASE("a swarm meets") {
  glm::dvec3 one = make_motion(plan_of(Role::swarm), Random{7, 1})->at(120).place;
  glm::dvec3 other = make_motion(plan_of(Role::swarm), Random{7, 2})->at(120).place;
  CHECK(glm::length(one - other) < 500);
  one = make_motion(plan_of(Role::swarm), Random{7, 1})->at(0).place;
  CHECK(glm::length(one - glm::dvec3{1000, 50, -2000}) <= 1500);
}

TEST_CASE("only who stands never moves") {
  CHECK_FALSE(make_motion(plan_of(Role::stand), Random{7, 1})->moves());
  CHECK(make_motion(plan_of(Role::walk), Random{7, 1})->moves());
}

TEST_CASE("a trace is followed from where the group begins, and its end is kept") {
  const auto trace = parse_trace("# a way\n0 0 0 0\n10 100 0 50\n\n20 100 5 50\n");
  REQUIRE(trace.has_value());
  MotionPlan plan = plan_of(Role::trace);
  plan.trace = std::make_shared<const Trace>(*trace);
  auto motion = make_motion(plan, Random{1, 1});
  CHECK(motion->at(0).place == plan.origin);
  CHECK(motion->at(5).place == plan.origin + glm::dvec3{50, 0, 25});
  CHECK(motion->at(15).place == plan.origin + glm::dvec3{100, 2.5, 50});
  CHECK(motion->at(99).place == plan.origin + glm::dvec3{100, 5, 50});
}

TEST_CASE("a broken trace is refused with its line") {
  CHECK(parse_trace("").error().substr(0, 2) == "1:");
  CHECK(parse_trace("0 0 0 0\n1 2 3\n").error().substr(0, 2) == "2:");
  CHECK(parse_trace("0 0 0 0\n\n1 2 3 4 5\n").error().substr(0, 2) == "3:");
  CHECK(parse_trace("1 0 0 0\n").error().substr(0, 2) == "1:");
  CHECK(parse_trace("0 0 0 0\n2 0 0 0\n2 0 0 0\n").error().substr(0, 2) == "3:");
}
