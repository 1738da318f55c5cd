#include "player_mix.h"

#include <rapidcheck/catch.h>
#include <algorithm>
#include <catch2/catch.hpp>

using namespace talus::load;

namespace {

std::size_t count(const std::vector<Role>& roles, Role role) {
  return static_cast<std::size_t>(std::count(roles.begin(), roles.end(), role));
}

}  // namespace

TEST_CASE("a single model applies to all players") {
  CHECK(count(deal(*parse_player_mix("fly"), 7), Role::fly) == 7);
}

TEST_CASE("shares are kept in every run of players") {
  const auto roles = deal(*parse_player_mix("walk=80,fly=15,teleport=5"), 200);
  CHECK(count(roles, Role::walk) == 160);
  CHECK(count(roles, Role::fly) == 30);
  CHECK(count(roles, Role::teleport) == 10);
  const std::vector<Role> few{roles.begin(), roles.begin() + 20};
  CHECK(count(few, Role::walk) == 16);
  CHECK(count(few, Role::fly) == 3);
}

TEST_CASE("mixed has several models") {
  CHECK(parse_player_mix("mixed")->shares[static_cast<std::size_t>(Role::walk)] > 0);
  CHECK(parse_player_mix("mixed")->shares[static_cast<std::size_t>(Role::fly)] > 0);
}

TEST_CASE("a trace brings its file") {
  CHECK(parse_player_mix("trace:way.txt")->trace_file == "way.txt");
  CHECK(parse_player_mix("trace:a=b.txt=3,walk=1")->trace_file == "a=b.txt");
}

TEST_CASE("an invalid mix is refused with a reason") {
  for (const char* text :
       {"", "run", "walk=0", "walk=-1", "walk=x", "walk=3x", "trace", "walk=1,,fly=1", "idle", "slow"}) {
    CAPTURE(text);
    const auto mix = parse_player_mix(text);
    REQUIRE_FALSE(mix.has_value());
    CHECK(mix.error().find("--model") == 0);
  }
}
