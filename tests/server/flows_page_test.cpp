// What operators read about flows.
#include "admin/flows_page.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

using namespace talus::server;

namespace {

FlowFigures figures(FlowName::Kind kind, const std::string& text, double ten, double minute,
                    std::uint64_t total) {
  return {std::make_shared<const FlowName>(FlowName{kind, text}), ten, minute, total};
}

FlowsReport report() {
  using Kind = FlowName::Kind;
  FlowsReport report{12, 3, {}};
  report.top[0] = {{figures(Kind::address, "203.0.113.9", 812.3e6, 640.1e6, 38'400'000'000),
                    figures(Kind::subject, "alice", 1.2e6, 0.9e6, 300'000'000),
                    figures(Kind::subject, "long gone", 0, 1000, 5'000'000'000)},
                   {nullptr, 813.5e6, 641.0e6, 43'700'000'000}};
  report.top[1] = {{figures(Kind::address, "2001:db8:0:1::/64", 2 << 20, 1 << 20, 1 << 30)},
                   {nullptr, 2 << 20, 1 << 20, 1 << 30}};
  report.top[2] = {{figures(Kind::subject, "b\x1b[2J", 10, 5, 42)}, {nullptr, 10, 10, 42}};
  return report;
}

}  // namespace

TEST_CASE("the table is aligned, has units, and names the flows") {
  CHECK(flows_text(report()) ==
        "12 sessions, 3 flows\n"
        "\n"
        "GENERATOR TIME         ms/s, 10 s   ms/s, 1 min   share      total s\n"
        "203.0.113.9                 812.3         640.1   100 %         38.4\n"
        "subject alice                 1.2           0.9     0 %          0.3\n"
        "all flows                   813.5         641.0   100 %         43.7\n"
        "\n"
        "SENT                  MiB/s, 10 s  MiB/s, 1 min   share    total MiB\n"
        "2001:db8:0:1::/64             2.0           1.0   100 %       1024.0\n"
        "all flows                     2.0           1.0   100 %       1024.0\n"
        "\n"
        "REFUSALS               /min, 10 s   /min, 1 min   share        total\n"
        "subject b\\x1b[2J            600.0         300.0    50 %           42\n"
        "all flows                   600.0         600.0   100 %           42\n");
}

TEST_CASE("the last user of a quiet server is still named") {
  FlowsReport quiet;
  quiet.top[0] = {{figures(FlowName::Kind::subject, "alice", 1000, 5000, 1'500'000)},
                  {nullptr, 1000, 5000, 1'500'000}};
  CHECK_THAT(flows_text(quiet), Catch::Contains("subject alice                 0.0           0.0   100 %"));
}

TEST_CASE("the table of an unused server has no shares") {
  CHECK_THAT(flows_text({}), Catch::Contains("all flows                     0.0           0.0     0 %"));
}

TEST_CASE("programs read the same as JSON, names as they are") {
  const auto page = nlohmann::json::parse(flows_json(report()));
  CHECK(page["sessions"] == 12);
  CHECK(page["generator_seconds"]["top"][0]["address"] == "203.0.113.9");
  CHECK(page["generator_seconds"]["top"][0]["per_second_10_s"] == Approx(0.8123));
  CHECK(page["generator_seconds"]["all"]["total"] == Approx(43.7));
  CHECK(page["sent_bytes"]["top"][0]["per_second_1_min"] == 1 << 20);
  CHECK(page["refusals"]["top"][0]["subject"] == "b\x1b[2J");
}

TEST_CASE("a name that was cut inside a character is still JSON") {
  FlowsReport cut;
  cut.top[0].top = {figures(FlowName::Kind::subject, "\xc3", 1, 1, 1)};
  CHECK(nlohmann::json::parse(flows_json(cut)).is_object());
}

TEST_CASE("JSON marks a name that was cut, and no other") {
  FlowsReport cut;
  cut.top[0].top = {
      figures(FlowName::Kind::subject, "whole", 1, 1, 1),
      {std::make_shared<const FlowName>(FlowName{FlowName::Kind::subject, "half", true}), 1, 1, 1}};
  const auto top = nlohmann::json::parse(flows_json(cut))["generator_seconds"]["top"];
  CHECK_FALSE(top[0].contains("cut"));
  CHECK(top[1]["cut"] == true);
}

TEST_CASE("JSON is ASCII, so that no name commands a terminal") {
  FlowsReport named;
  named.top[0].top = {figures(FlowName::Kind::subject,
                              "\xc2\x9b"
                              "2J\xc3\xa9",
                              1, 1, 1)};
  const std::string page = flows_json(named);
  CHECK(std::all_of(page.begin(), page.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
  CHECK(nlohmann::json::parse(page)["generator_seconds"]["top"][0]["subject"] ==
        "\xc2\x9b"
        "2J\xc3\xa9");
}

TEST_CASE("one flow is one flow") {
  FlowsReport one;
  one.flows = 1;
  one.sessions = 1;
  CHECK_THAT(flows_text(one), Catch::StartsWith("1 session, 1 flow\n"));
  CHECK_THAT(flows_text({}), Catch::StartsWith("0 sessions, 0 flows\n"));
}
