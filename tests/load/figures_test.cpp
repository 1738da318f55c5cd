// Conditions on figures, and figures on an outcome.
#include "figures.h"

#include <catch2/catch.hpp>

using namespace talus::load;
using std::chrono::milliseconds;

namespace {

std::vector<std::string> check(const std::string& condition, const Figures& figures) {
  const auto parsed = parse_condition(condition);
  REQUIRE(parsed.has_value());
  return those_that_hold({*parsed}, figures);
}

Tally& of(Outcome& outcome, Role role) {
  return outcome.tallies[static_cast<std::size_t>(role)];
}

}  // namespace

TEST_CASE("a condition that holds is named with its figure's value") {
  CHECK(check("p99_ms>50", {{"p99_ms", 51.25}}) ==
        std::vector<std::string>{"--fail-if p99_ms>50: p99_ms is 51.25"});
  CHECK(check("p99_ms>50", {{"p99_ms", 50}}).empty());
}

TEST_CASE("every relation is what it says") {
  const Figures two{{"errors", 2}};
  CHECK(check("errors>=2", two).size() == 1);
  CHECK(check("errors<=2", two).size() == 1);
  CHECK(check("errors==2", two).size() == 1);
  CHECK(check("errors!=2", two).empty());
  CHECK(check("errors<2", two).empty());
  CHECK(check("errors<3", two).size() == 1);
}

TEST_CASE("a figure that was not measured fails its condition") {
  CHECK(check("cpu_s_per_million>1", {}).size() == 1);
}

TEST_CASE("what is no condition is refused with a reason") {
  for (const char* text : {"", "p99_ms", "p99_ms>", "p99_ms>x", "p99_ms>5x", "p99_ms=>5", "speed>5", ">5"}) {
    CAPTURE(text);
    const auto condition = parse_condition(text);
    REQUIRE_FALSE(condition.has_value());
    CHECK(condition.error().find("--fail-if") == 0);
  }
}

TEST_CASE("every figure has a name that a condition takes") {
  Outcome outcome;
  Tally& walk = of(outcome, Role::walk);
  for (Histogram* waits :
       {&walk.join, &walk.travel, &walk.requests, &walk.first_chunk, &walk.full_view, &outcome.lateness}) {
    waits->record(milliseconds{3});
  }
  outcome.end = {1, 10, 5, 1000, 0, {1.5, 1e6, 10, {}}};
  outcome.begin.server = {0.5, 1e6, 10, {}};
  outcome.before = outcome.after = outcome.idle = outcome.begin.server;
  outcome.idle_joined = 1;
  const Figures figures = figures_of(outcome);
  for (const auto& [name, value] : figures) {
    CAPTURE(name);
    CHECK(is_figure(name));
  }
  CHECK(figures.at("cpu_s_per_million") == Approx(1.0 / 15 * 1e6));
  CHECK(figures.at("cpu_s_per_million_messages") == Approx(1.0 / 10 * 1e6));
}

TEST_CASE("slow and greedy clients are not the players") {
  Outcome outcome;
  of(outcome, Role::slow).travel.record(milliseconds{5000});
  of(outcome, Role::greedy).errors["overloaded"] = 7;
  of(outcome, Role::walk).travel.record(milliseconds{5});
  const Figures figures = figures_of(outcome);
  CHECK(figures.at("max_ms") == 5);
  CHECK(figures.at("errors") == 0);
  CHECK(figures.at("greedy_errors") == 7);
}

TEST_CASE("what anybody finds wrong is wrong") {
  Outcome outcome;
  Tally& slow = of(outcome, Role::slow);
  slow.wrong(slow.bad_chunks, "slow 3: a chunk");
  CHECK(figures_of(outcome).at("wrong") == 1);
  CHECK(outcome.all().first_wrong == "slow 3: a chunk");
}

TEST_CASE("what is resident grows by the means of the first tenth and the last") {
  Outcome outcome;
  for (int second = 0; second < 30; ++second) {
    // Up and down by a tenth, from second to second; 20 % more in the end.
    const double base = second < 15 ? 100 : 120;
    outcome.resident_bytes.push_back(base * (second % 3 == 0 ? 0.9 : second % 3 == 1 ? 1.0 : 1.1));
  }
  CHECK(figures_of(outcome).at("resident_growth_percent") == Approx(20));
  outcome.resident_bytes = {100, 103};
  CHECK(figures_of(outcome).at("resident_growth_percent") == Approx(3));
  outcome.resident_bytes = {100};
  CHECK(figures_of(outcome).count("resident_growth_percent") == 0);
}
