// Thresholds on figures, and the figures of a run.
#include "figures.h"
#include "report.h"

#include <catch2/catch.hpp>

using namespace talus::load;
using std::chrono::milliseconds;

namespace {

std::vector<std::string> check(const std::string& threshold, const Figures& figures) {
  const auto parsed = parse_threshold(threshold);
  REQUIRE(parsed.has_value());
  return crossed_thresholds({*parsed}, figures);
}

Tally& of(RunResult& result, Role role) {
  return result.tallies[static_cast<std::size_t>(role)];
}

}  // namespace

TEST_CASE("a threshold that holds is named with its figure's value") {
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

TEST_CASE("a figure that was not measured fails its threshold") {
  CHECK(check("cpu_s_per_million>1", {}).size() == 1);
}

TEST_CASE("an invalid threshold is refused with a reason") {
  for (const char* text : {"", "p99_ms", "p99_ms>", "p99_ms>x", "p99_ms>5x", "p99_ms=>5", "speed>5", ">5"}) {
    CAPTURE(text);
    const auto threshold = parse_threshold(text);
    REQUIRE_FALSE(threshold.has_value());
    CHECK(threshold.error().find("--fail-if") == 0);
  }
}

TEST_CASE("every figure has a name that a threshold takes") {
  RunResult result;
  Tally& walk = of(result, Role::walk);
  for (talus::measure::Histogram* waits :
       {&walk.join, &walk.travel, &walk.requests, &walk.first_chunk, &walk.full_view, &walk.horizon,
        &walk.near, &walk.returns, &walk.edit_ack, &walk.edit_arrival, &walk.edit_other_server,
        &result.lateness}) {
    waits->record(milliseconds{3});
  }
  walk.new_patches = 4;
  walk.longest_without = milliseconds{70};
  result.rates.emplace("rates.address_chunks", RateModel{100, milliseconds{1000}});
  result.end = {1, 10, 5, 1000, 7, 0, {1.5, 1e6, 10, {}}};
  result.begin.server = {0.5, 1e6, 10, {}};
  result.begin.server.counters = {{"talus_chunks_sent_total", 100},
                                  {"talus_chunks_generated_total", 200},
                                  {"talus_patches_generated_total", 10}};
  result.end.server.counters = {{"talus_chunks_sent_total", 110},
                                {"talus_chunks_generated_total", 213},
                                {"talus_patches_generated_total", 15}};
  result.before = result.after = result.idle = result.begin.server;
  result.idle_joined = 1;
  const Figures figures = figures_of(result);
  for (const auto& [name, value] : figures) {
    CAPTURE(name);
    CHECK(is_figure(name));
  }
  CHECK(figures.at("cpu_s_per_million") == Approx(1.0 / 15 * 1e6));
  CHECK(figures.at("cpu_s_per_million_messages") == Approx(1.0 / 10 * 1e6));
  CHECK(figures.at("generated_per_sent") == Approx(1.3));
  CHECK(figures.at("patches_per_new") == Approx(1.25));
  CHECK(figures.at("longest_without_ms") == 70);
  CHECK(figures.at("near_p99_ms") == Approx(3));
  CHECK(figures.at("return_max_ms") == Approx(3));
  CHECK(figures.at("held_percent") == 0);
}

TEST_CASE("one line says which of the server's own rates held the players, and what to change") {
  Plan plan;
  plan.server = {asio::ip::make_address("127.0.0.1"), 4780};
  plan.servers = {plan.server};
  RunResult result;
  RateModel held{8'192, milliseconds{1'000}};
  for (int second = 0; second < 10; ++second) held.add(1, 8'192, true);
  const RateModel ample{1'000'000, milliseconds{1'000}};
  result.rates.emplace("rates.address_chunks", held);
  result.rates.emplace("rates.session_chunks", ample);
  CHECK_THAT(
      report(plan, result),
      Catch::Contains(
          "\n  held: 100 % of the time by the server's own rates.address_chunks (8192 a second for each "
          "address); for more, raise it there (0: no limit), or spread the players by "
          "--from-addresses\n"));
  CHECK(report_json(plan, result)["held_by"] == nlohmann::json{{"rates.address_chunks", 1.0}});
  result.rates.erase("rates.address_chunks");
  CHECK_THAT(report(plan, result), !Catch::Contains("held:"));
}

TEST_CASE("slow and greedy clients are not the players") {
  RunResult result;
  of(result, Role::slow).travel.record(milliseconds{5000});
  of(result, Role::greedy).errors["overloaded"] = 7;
  of(result, Role::walk).travel.record(milliseconds{5});
  const Figures figures = figures_of(result);
  CHECK(figures.at("max_ms") == 5);
  CHECK(figures.at("errors") == 0);
  CHECK(figures.at("greedy_errors") == 7);
}

TEST_CASE("a fault found by any player is a fault") {
  RunResult result;
  Tally& slow = of(result, Role::slow);
  slow.wrong(slow.bad_chunks, "slow 3: a chunk");
  CHECK(figures_of(result).at("wrong") == 1);
  CHECK(result.all().first_wrong == "slow 3: a chunk");
}

TEST_CASE("resident memory grows by the means of the first tenth and the last") {
  RunResult result;
  for (int second = 0; second < 30; ++second) {
    // Up and down by a tenth, from second to second; 20 % more in the end.
    const double base = second < 15 ? 100 : 120;
    result.resident_bytes.push_back(base * (second % 3 == 0 ? 0.9 : second % 3 == 1 ? 1.0 : 1.1));
  }
  CHECK(figures_of(result).at("resident_growth_percent") == Approx(20));
  result.resident_bytes = {100, 103};
  CHECK(figures_of(result).at("resident_growth_percent") == Approx(3));
  result.resident_bytes = {100};
  CHECK(figures_of(result).count("resident_growth_percent") == 0);
}
