#include "chunks/cache/flat_map.h"

#include <cstdint>
#include <map>
#include <random>
#include <string>

#include <catch2/catch.hpp>

using talus::server::FlatMap;

namespace {

/// All keys stand at one of four places, and wrap around the table's end.
struct CrowdedKey {
  std::uint32_t number = 0;
  bool operator==(const CrowdedKey&) const = default;
  auto operator<=>(const CrowdedKey&) const = default;
};

}  // namespace

template <>
struct std::hash<CrowdedKey> {
  std::size_t operator()(const CrowdedKey& key) const noexcept { return 0xFFFF'FFFE + key.number % 4; }
};

TEST_CASE("a flat map holds what a std::map holds after any inserts and erasures") {
  std::mt19937 random{1};
  FlatMap<CrowdedKey, std::string> flat;
  std::map<CrowdedKey, std::string> plain;
  for (int step = 0; step < 20'000; ++step) {
    const CrowdedKey key{static_cast<std::uint32_t>(random() % 40)};
    if (random() % 2 == 0) {
      const auto [value, added] = flat.emplace(key);
      REQUIRE(added == !plain.contains(key));
      value = plain[key] = std::to_string(step);
    } else {
      REQUIRE(flat.erase(key) == (plain.erase(key) == 1));
    }
    REQUIRE(flat.size() == plain.size());
    REQUIRE(flat.empty() == plain.empty());
  }
  for (std::uint32_t number = 0; number < 40; ++number) {
    const auto known = plain.find({number});
    const std::string* const value = flat.find({number});
    REQUIRE((value != nullptr) == (known != plain.end()));
    if (value != nullptr) REQUIRE(*value == known->second);
  }
  std::map<CrowdedKey, std::string> listed;
  for (const auto& [key, value] : flat) listed.emplace(key, value);
  CHECK(listed == plain);
}

TEST_CASE("values of a flat map keep their addresses while it grows") {
  FlatMap<CrowdedKey, int> map;
  int* const first = &map[{0}];
  *first = 7;
  for (std::uint32_t number = 1; number < 5'000; number += 1) map[{number}] = 1;
  CHECK(map.find({0}) == first);
  CHECK(*first == 7);
}
