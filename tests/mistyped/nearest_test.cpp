#include <talus/mistyped/nearest.h>

#include <array>
#include <string>

#include <catch2/catch.hpp>

using namespace talus;

TEST_CASE("the nearest name is the one with the fewest changes") {
  constexpr std::array<std::string_view, 4> kNames{"listen", "limits.connections", "log.level", "store"};
  CHECK(meant("lisen", kNames) == "listen");
  CHECK(meant("limit.conections", kNames) == "limits.connections");
  CHECK(meant("loglevel", kNames) == "log.level");
  CHECK(meant("stroe", kNames) == "store");
}

TEST_CASE("on a tie the first candidate is the nearest") {
  constexpr std::array<std::string_view, 2> kNames{"ab", "ac"};
  CHECK(meant("ad", kNames) == "ab");
}

TEST_CASE("a very long word is compared by its beginning") {
  const std::string name(128, 'b');
  const std::array<std::string_view, 2> names{"a", name};
  CHECK(meant(std::string(1'000'000, 'b'), names) == name);
}

TEST_CASE("a word far from all names has no suggestion") {
  constexpr std::array<std::string_view, 4> kOthers{"store", "admin", "world", "data"};
  for (const std::string_view word : {"start", "limit", "port", "rate"}) CHECK(meant(word, kOthers).empty());
  constexpr std::array<std::string_view, 2> kNames{"check", "status"};
  CHECK(meant("chek", kNames) == "check");
  CHECK(meant("satus", kNames) == "status");
  CHECK(meant("melt", kNames).empty());
  CHECK(meant("checks on", kNames).empty());
  CHECK(meant("", kNames).empty());
  CHECK(meant("chek", {}).empty());
}
