#include "compare.h"

#include <catch2/catch.hpp>

using namespace talus::load;
using nlohmann::json;

namespace {

json run(double p99, int players = 20) {
  return {{"format", 2}, {"settings", {{"players", players}}}, {"figures", {{"p99_ms", p99}, {"wrong", 0}}}};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a comparison gives ratios") {
  const auto table = compare(run(20).dump(), run(30));
  REQUIRE(table.has_value());
  CHECK(has(*table, "p99_ms"));
  CHECK(has(*table, "x 1.50"));
}

TEST_CASE("settings that differ are named") {
  CHECK(has(*compare(run(20, 10).dump(), run(20, 30)), "players: 10 before, 30 now"));
  CHECK_FALSE(has(*compare(run(20).dump(), run(20)), "setting"));
}

TEST_CASE("an invalid result file is refused") {
  for (const char* text : {"", "{", "[]", "{}", "{\"format\":1,\"settings\":{},\"figures\":{}}",
                           "{\"format\":2,\"figures\":[]}"}) {
    CAPTURE(text);
    CHECK_FALSE(compare(text, run(1)).has_value());
  }
}
