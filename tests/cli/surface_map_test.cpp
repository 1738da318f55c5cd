#include "surface_map.h"

#include <catch2/catch.hpp>

#include "worlds.h"

using namespace talus;
using namespace talus::cli;
using namespace talus::cli::testing;

TEST_CASE("the ground is known where air above it is") {
  SurfaceMap map{materials()};
  map.add(key_at(0, 1, 0), flat(kStone, 10, kAir));
  const auto point = map.at(3, 4);
  REQUIRE(point);
  CHECK(point->top == 41);
  CHECK(point->ground == 41);
  CHECK(point->material == kStone);
  CHECK_FALSE(point->water);
  CHECK_FALSE(map.at(32, 4));
}

TEST_CASE("ground that fills its chunk waits for the chunk above") {
  SurfaceMap map{materials()};
  map.add(key_at(0, 0, 0), Chunk::uniform(kStone));
  CHECK_FALSE(map.at(0, 0));
  CHECK(map.next_row_up(0, 0) == 1);
  map.add(key_at(0, 1, 0), Chunk::uniform(kAir));
  REQUIRE(map.at(0, 0));
  CHECK(map.at(0, 0)->top == 31);
  CHECK_FALSE(map.next_row_up(0, 0));
}

TEST_CASE("chunks may come in any order") {
  SurfaceMap map{materials()};
  map.add(key_at(-1, 1, -1), flat(kGrass, 3, kAir));
  map.add(key_at(-1, 0, -1), Chunk::uniform(kStone));
  REQUIRE(map.at(-1, -1));
  CHECK(map.at(-1, -1)->top == 34);
  CHECK(map.at(-1, -1)->material == kGrass);
}

TEST_CASE("under water the surface has the bed and the water's top") {
  SurfaceMap map{materials()};
  map.add(key_at(0, 0, 0), layered(kStone, 5, kWater, 20));
  const auto point = map.at(0, 0);
  REQUIRE(point);
  CHECK(point->water == kWater);
  CHECK(point->ground == 4);
  CHECK(point->top == 19);
  CHECK(point->material == kStone);
}

TEST_CASE("coarser chunks change nothing") {
  SurfaceMap map{materials()};
  map.add(key_at(0, 0, 0, 1), flat(kStone, 10, kAir));
  CHECK_FALSE(map.at(0, 0));
  CHECK(map.extent().width == 0);
}

TEST_CASE("the extent covers all chunks seen") {
  SurfaceMap map{materials()};
  map.add(key_at(-2, 0, 1), Chunk::uniform(kAir));
  map.add(key_at(1, 5, 1), Chunk::uniform(kAir));
  const Extent extent = map.extent();
  CHECK(extent.x == -64);
  CHECK(extent.z == 32);
  CHECK(extent.width == 128);
  CHECK(extent.depth == 32);
}

TEST_CASE("an extent that leaves the world is an error, not an overflow") {
  CHECK(extent_around(0, 0, 64, 64)->x == -32);
  CHECK_FALSE(extent_around(std::int64_t{1} << 36, 0, 64, 64));
  CHECK_FALSE(extent_around((std::int64_t{1} << 36) - 1, 0, 64, 64));
  CHECK_FALSE(extent_around(std::numeric_limits<std::int64_t>::max(), 0, 64, 64));
}
