#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include "reference.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

Region any_region(int widest) {
  return {*rc::gen::inRange<std::int64_t>(-3000, 3000), *rc::gen::inRange<std::int64_t>(-3000, 3000),
          *rc::gen::inRange(1, widest), *rc::gen::inRange(1, widest), Lod::of(*rc::gen::inRange(0, 7))};
}

test::reference::Stack stack_at(const World& world, const Terrain& terrain, int x, int z) {
  test::reference::Stack strata;
  for (std::size_t p = 0; p < terrain.strata.size(); ++p) {
    strata.push_back({terrain.strata_materials[p], terrain.strata[p].at(x, z)});
  }
  std::vector<std::int32_t> thickness;
  for (const Field& loose : terrain.loose) thickness.push_back(loose.at(x, z));
  return test::reference::insert(world, strata, thickness);
}

TEST_CASE("Loose layers lie on the strata by weight, and the surface does not move") {
  CHECK(rc::check([] {
    const World world = test::small_world(*rc::gen::arbitrary<std::uint64_t>());
    const Terrain terrain = generate_terrain(world, any_region(40));
    const Stacks stacks = generate_stacks(world, terrain.region);
    RC_ASSERT(stacks.tops.back().values == terrain.surface.values);
    for (int z = 0; z < terrain.region.depth; ++z) {
      for (int x = 0; x < terrain.region.width; ++x) {
        const auto expected = stack_at(world, terrain, x, z);
        std::int32_t probe = 0;
        for (const auto& layer : expected) {  // every height of the column has the material it should have
          if (layer.top_fx == probe) continue;
          std::size_t plane = 0;
          while (stacks.tops[plane].at(x, z) <= probe) ++plane;
          RC_ASSERT(stacks.materials[plane] == layer.material);
          RC_ASSERT(stacks.tops[plane].at(x, z) == layer.top_fx);
          probe = layer.top_fx;
        }
      }
    }
  }));
}

TEST_CASE("Stacks that are filled again, by whichever generator, are as fresh ones") {
  CHECK(rc::check([] {
    const World world = test::small_caves(*rc::gen::arbitrary<std::uint64_t>());
    std::array<Generator, 2> generators{Generator{world}, Generator{world}};
    std::array<Stacks, 2> kept;
    for (int round = 0; round < 6; ++round) {
      const Region region = any_region(40);
      Stacks& stacks = kept[*rc::gen::inRange<std::size_t>(0, 2)];
      generators[*rc::gen::inRange<std::size_t>(0, 2)].generate(region, stacks);
      const Stacks fresh = generate_stacks(world, region);
      RC_ASSERT(stacks.materials == fresh.materials);
      RC_ASSERT(stacks.tops.size() == fresh.tops.size());
      for (std::size_t plane = 0; plane < fresh.tops.size(); ++plane) {
        RC_ASSERT(stacks.tops[plane].width == fresh.tops[plane].width);
        RC_ASSERT(stacks.tops[plane].values == fresh.tops[plane].values);
      }
      RC_ASSERT(stacks.caves.floor.values == fresh.caves.floor.values);
      RC_ASSERT(stacks.caves.roof.values == fresh.caves.roof.values);
      RC_ASSERT(stacks.ground_fx(0, 0) == fresh.ground_fx(0, 0));
    }
  }));
}

TEST_CASE("Settled loose material is at rest, and starts from equation 3 in the endless plane") {
  CHECK(rc::check([] {
    const World world = test::small_world(*rc::gen::arbitrary<std::uint64_t>());
    const Region region = any_region(24);
    const Terrain terrain = generate_terrain(world, region);
    const Terrain wide = generate_terrain(world, region.expanded(40));
    for (std::size_t m = 0; m < world.loose().size(); ++m) {
      const LooseSpec& loose = world.loose()[m];
      Field start{wide.region.width, wide.region.depth};
      for (std::size_t i = 0; i < start.values.size(); ++i) {
        const std::int64_t s = wide.slope.values[i];
        const std::int64_t t = loose.t_fx >> region.lod.value();
        start.values[i] = s > loose.S_fx ? 0 : static_cast<std::int32_t>(t * (loose.S_fx - s) / loose.S_fx);
      }
      test::reference::remove_until_stable(start, loose.c_fx);
      RC_ASSERT(start.cropped(40).values == terrain.loose[m].values);
    }
  }));
}

TEST_CASE("Every voxel of a chunk has the material of the stack at its centre") {
  CHECK(rc::check([] {
    const World world = test::small_world(*rc::gen::arbitrary<std::uint64_t>());
    const Lod lod = Lod::of(*rc::gen::inRange(0, 7));
    const ChunkCoord coord{*rc::gen::inRange(-40, 40), *rc::gen::inRange(-2, 5), *rc::gen::inRange(-40, 40)};
    const VoxelPos origin = chunk_origin(coord);
    const Terrain terrain = generate_terrain(world, {origin.x, origin.z, kChunkSize, kChunkSize, lod});
    const Chunk chunk = generate_chunk(world, {coord, lod});
    std::vector<MaterialId> voxels(kChunkVolume);
    chunk.copy_to(std::span<MaterialId, kChunkVolume>{voxels});
    for (int z = 0; z < kChunkSize; ++z) {
      for (int x = 0; x < kChunkSize; ++x) {
        const auto stack = stack_at(world, terrain, x, z);
        for (int y = 0; y < kChunkSize; ++y) {
          const std::size_t index = static_cast<std::size_t>((y * kChunkSize + z) * kChunkSize + x);
          RC_ASSERT(voxels[index] == test::reference::voxel(world, stack, origin.y + y, lod));
        }
      }
    }
  }));
}

TEST_CASE("Outside its mixed range every chunk of a column is uniform") {
  CHECK(rc::check([] {
    const World world = test::small_world(*rc::gen::arbitrary<std::uint64_t>());
    const Lod lod = Lod::of(*rc::gen::inRange(0, 7));
    const ChunkCoord coord{*rc::gen::inRange(-40, 40), 0, *rc::gen::inRange(-40, 40)};
    const VoxelPos origin = chunk_origin(coord);
    const Stacks stacks = generate_stacks(world, {origin.x, origin.z, kChunkSize, kChunkSize, lod});
    const MixedRange range = mixed_range(world, stacks, coord.x, coord.z);
    for (std::int32_t y = -3; y < 6; ++y) {
      const Chunk chunk = extract_chunk(world, stacks, {coord.x, y, coord.z});
      if (y < range.first) RC_ASSERT(chunk == Chunk::uniform(range.below));
      if (y > range.last) RC_ASSERT(chunk == Chunk::uniform(kAir));
      const auto everywhere = uniform_everywhere(world, {{coord.x, y, coord.z}, lod});
      if (everywhere) RC_ASSERT(chunk == Chunk::uniform(*everywhere));
    }
  }));
}

TEST_CASE("A chunk is the same whatever memory it is made in, and gives its own away") {
  const World& world = default_world();
  const Stacks stacks = generate_stacks(world, {0, 0, 64, 32, Lod{}});
  Layers memory{{kAir, kWater, kAir}, std::vector<std::uint8_t>(5)};  // anything, not even valid
  for (std::int32_t y = -1; y < 5; ++y) {
    for (std::int32_t x = 0; x < 2; ++x) {
      Chunk chunk = extract_chunk(world, stacks, {x, y, 0}, std::move(memory));
      CHECK(chunk == extract_chunk(world, stacks, {x, y, 0}));
      const std::vector<MaterialId> materials = chunk.layers()->materials;
      memory = std::move(chunk).take_layers();
      CHECK(memory.materials == materials);
    }
  }
}

}  // namespace
}  // namespace talus::terrain
