#include "config/nearest.h"

#include <array>
#include <string>

#include <catch2/catch.hpp>

using namespace talus::server;

TEST_CASE("the nearest name is the one with the fewest changes") {
  constexpr std::array<std::string_view, 3> kNames{"listen", "limits.connections", "log.level"};
  CHECK(nearest("lisen", kNames) == "listen");
  CHECK(nearest("limit.conections", kNames) == "limits.connections");
  CHECK(nearest("loglevel", kNames) == "log.level");
}

TEST_CASE("on a tie the first candidate is the nearest") {
  constexpr std::array<std::string_view, 2> kNames{"ab", "ac"};
  CHECK(nearest("ad", kNames) == "ab");
}

TEST_CASE("a very long word is compared by its beginning") {
  constexpr std::array<std::string_view, 2> kNames{"a", "b"};
  CHECK(nearest("b" + std::string(1'000'000, 'x'), kNames) == "b");
}
