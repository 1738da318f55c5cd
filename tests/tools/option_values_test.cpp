#include <talus/tools/option_values.h>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::tools;

TEST_CASE("Every pair of 64-bit numbers reads back as written") {
  CHECK(rc::check([](std::int64_t first, std::int64_t second) {
    const auto pair = parse_pair("--center", std::to_string(first) + "," + std::to_string(second));
    RC_ASSERT(pair.has_value());
    RC_ASSERT(*pair == (IntegerPair{first, second}));
  }));
}

TEST_CASE("An invalid pair is refused by name") {
  for (const char* text :
       {"", "5", "5,", ",5", "5,6,7", "5;6", "1.5,2", " 1,2", "1,2 ", "+1,2", "x,z", "0x10,0"}) {
    const auto pair = parse_pair("--center", text);
    REQUIRE_FALSE(pair);
    CHECK(pair.error().exit_code == kExitWrongUse);
    CHECK(pair.error().message == "--center: '" + std::string{text} +
                                      "' is not a pair of whole numbers; write it like --center 640,-32");
  }
}

TEST_CASE("A number past 64 bits is refused") {
  const auto pair = parse_pair("--center", "9223372036854775808,0");
  REQUIRE_FALSE(pair);
  CHECK(pair.error().message == "--center: 9223372036854775808 does not fit 64 bits");
}

TEST_CASE("Sizes are lengths") {
  CHECK(parse_size("--size", "1,64", 64));
  CHECK_FALSE(parse_size("--size", "0,64", 64));
  CHECK_FALSE(parse_size("--size", "-1,64", 64));
  CHECK(parse_size("--size", "1,65", 64).error().message == "--size: 65 is not a length from 1 to 64");
}

TEST_CASE("A region around a base voxel has that voxel's column in its middle at every level") {
  for (int level = 0; level <= Lod::kMax; ++level) {
    const auto region = region_around("--center", {-1, 1000}, {64, 33}, Lod::of(level));
    REQUIRE(region);
    CHECK(region->x == -1 - 32);
    CHECK(region->z == (1000 >> level) - 16);
    CHECK(region->lod == Lod::of(level));
  }
}

TEST_CASE("Regions may touch the end of the world at every level, and not pass it") {
  constexpr std::int64_t kEnd = std::int64_t{1} << 36;
  for (int level = 0; level <= Lod::kMax; ++level) {
    const Lod lod = Lod::of(level);
    const std::int64_t span = std::int64_t{10} << level;
    CHECK(region_from_origin("--origin", {kEnd - span, -kEnd}, {10, 10}, lod));
    CHECK_FALSE(region_from_origin("--origin", {kEnd - span, -kEnd}, {11, 10}, lod));
  }
  CHECK(region_from_origin("--origin", {kEnd, 0}, {1, 1}, Lod{}).error().message ==
        "--origin: x = 68719476736 lies outside the world, which reaches from -68719476736 to 68719476735");
  CHECK(region_around("--center", {0, -kEnd}, {10, 10}, Lod{}).error().message ==
        "--center: column z = -68719476741 lies outside the world, which has columns -68719476736 to "
        "68719476735 at level of detail 0");
}
