#include <talus/mistyped/nearest.h>

#include <array>
#include <string>

#include <catch2/catch.hpp>

using namespace talus;

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

TEST_CASE("a word far from all names has no suggestion") {
  constexpr std::array<std::string_view, 2> kNames{"check", "status"};
  CHECK(meant("chek", kNames) == "check");
  CHECK(meant("satus", kNames) == "status");
  CHECK(meant("melt", kNames).empty());
  CHECK(meant("", kNames).empty());
  CHECK(meant("chek", {}).empty());
}
