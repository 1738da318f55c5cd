#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>

#include "reference.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

TEST_CASE("Heights, strata and slope of a coarse level are level 0's at its columns") {
  CHECK(rc::check([] {
    const World world = test::small_world(*rc::gen::arbitrary<std::uint64_t>());
    const int level = *rc::gen::inRange(1, 7);
    const std::int64_t x = *rc::gen::inRange<std::int64_t>(-2000, 2000);
    const std::int64_t z = *rc::gen::inRange<std::int64_t>(-2000, 2000);
    const Terrain coarse = generate_terrain(world, {x, z, 3, 2, Lod::of(level)});
    for (int dz = 0; dz < 2; ++dz) {
      for (int dx = 0; dx < 3; ++dx) {
        const Terrain fine = generate_terrain(world, {(x + dx) << level, (z + dz) << level, 1, 1, Lod{}});
        RC_ASSERT(coarse.surface.at(dx, dz) == fine.surface.at(0, 0) >> level);
        RC_ASSERT(coarse.slope.at(dx, dz) == fine.slope.at(0, 0));
        RC_ASSERT(coarse.strata.size() == fine.strata.size());
        for (std::size_t p = 0; p < fine.strata.size(); ++p) {
          RC_ASSERT(coarse.strata[p].at(dx, dz) == fine.strata[p].at(0, 0) >> level);
        }
      }
    }
  }));
}

TEST_CASE("The halo of a coarse level is the halo of its thinner layers") {
  const World& world = test::sample_world("classic");
  int previous = world.halo();
  CHECK(halo_columns(world, Lod{}) == world.halo());
  for (int level = 1; level <= Lod::kMax; ++level) {
    const int halo = halo_columns(world, Lod::of(level));
    CHECK(halo <= (previous + 1) / 2);
    previous = halo;
  }
}

TEST_CASE("Far hills keep their grass: the top voxel of a coarse column is the top of its stack") {
  const World& world = test::sample_world("classic");
  const MaterialId grass = world.loose()[world.loose_bottom_up().back()].material;
  int topped = 0;
  for (int cx = -4; cx < 4; ++cx) {
    const Region tile{std::int64_t{cx} * kChunkSize, 0, kChunkSize, kChunkSize, Lod::of(4)};
    const Stacks stacks = generate_stacks(world, tile);
    for (std::int32_t y = 0; y < 3; ++y) {
      const Chunk chunk = extract_chunk(world, stacks, {cx, y, 0});
      for (int x = 0; x < kChunkSize; ++x) {
        for (const Run& run : chunk.runs(x, 0)) topped += run.material == grass ? 1 : 0;
      }
    }
  }
  CHECK(topped > 20);
}

}  // namespace
}  // namespace talus::terrain
