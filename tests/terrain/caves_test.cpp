#include <algorithm>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/heights.h>

#include "features/caves.h"
#include "features_of.h"
#include "voxel_block.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

constexpr int kSide = 224;

struct Place {
  World world;
  Stacks stacks;
  test::VoxelBlock voxels;
};

Place place(World world, Lod lod, std::int64_t chunk_x = -3, std::int64_t chunk_z = -3) {
  Stacks stacks = generate_stacks(world, {chunk_x * kChunkSize, chunk_z * kChunkSize, kSide, kSide, lod});
  test::VoxelBlock voxels{world, stacks};
  return {std::move(world), std::move(stacks), std::move(voxels)};
}

// With the sea up to where the caves are, and cliffs around it.
World drowned_caves(std::uint64_t seed, int steps) {
  std::string text = test::small_caves_text(seed, steps);
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("sea_level = 0.3", "sea_level = 0.9");
  replace("gain = 1.0", "gain = 16.0");
  return World::parse(text, "drowned").value();
}

bool loose(const World& world, MaterialId material) {
  return world.materials()[to_integer(material)].kind == MaterialKind::eroded;
}

// Air under something solid.
int roofed_columns(const test::VoxelBlock& voxels) {
  int count = 0;
  for (int z = 0; z < voxels.depth(); ++z) {
    for (int x = 0; x < voxels.width(); ++x) {
      const int ground = voxels.ground(x, z);
      bool air = false;
      for (int y = 0; y < ground; ++y) air |= voxels.at(x, y, z) == kAir;
      count += air ? 1 : 0;
    }
  }
  return count;
}

// Columns open to the sky farther down than loose material could have gone.
int entrances(const World& world, const Stacks& stacks) {
  std::int32_t loose_fx = 0;
  for (const LooseSpec& each : world.loose()) loose_fx += each.thickness_at(stacks.region.lod);
  int count = 0;
  for (int z = 0; z < stacks.region.depth; ++z) {
    for (int x = 0; x < stacks.region.width; ++x) {
      if (!stacks.caves.has(x, z)) continue;
      count += stacks.ground_fx(x, z) < stacks.caves.roof.at(x, z) - loose_fx ? 1 : 0;
    }
  }
  return count;
}

// Solid voxels that cannot be reached from below through solid ones. A roof is carried by a straight line of
// roofs no longer than the span, so what lies nearer to the region's edge may be carried from outside of it.
int hanging_voxels(const Place& at) {
  const int margin = test::feature_of<Caves>(at.world).plan().span_at(at.stacks.region.lod);
  const std::vector<bool> reached = at.voxels.reached_from_below();
  int hanging = 0;
  for (int y = 0; y < at.voxels.rows(); ++y) {
    for (int z = margin; z < at.voxels.depth() - margin; ++z) {
      for (int x = margin; x < at.voxels.width() - margin; ++x) {
        hanging += at.voxels.solid(x, y, z) && !reached[at.voxels.index(x, y, z)] ? 1 : 0;
      }
    }
  }
  return hanging;
}

TEST_CASE("Rock left by caves is connected with the ground") {
  for (const int steps : {0, 8}) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
      for (const int level : {0, 1, 2}) {
        INFO(steps << " steps of erosion, seed " << seed << ", level " << level);
        const Place at = place(test::small_caves(seed, steps), Lod::of(level));
        CHECK(roofed_columns(at.voxels) > 0);
        CHECK(hanging_voxels(at) == 0);
      }
    }
  }
}

TEST_CASE("Caves open to the sky") {
  for (const int steps : {0, 8}) {
    for (const int level : {0, 1}) {
      INFO(steps << " steps of erosion, level " << level);
      const Place at = place(test::small_caves(1, steps), Lod::of(level));
      CHECK(entrances(at.world, at.stacks) > 20);
    }
  }
}

TEST_CASE("No loose voxel lies over air or hangs over an entrance") {
  for (const int steps : {0, 8}) {
    for (const int level : {0, 1, 2}) {
      const Place at = place(test::small_caves(2, steps), Lod::of(level));
      int over_air = 0;
      for (int y = 1; y < at.voxels.rows(); ++y) {
        for (int z = 0; z < kSide; ++z) {
          for (int x = 0; x < kSide; ++x) {
            const bool air_below = at.voxels.at(x, y - 1, z) == kAir;
            over_air += air_below && loose(at.world, at.voxels.at(x, y, z)) ? 1 : 0;
          }
        }
      }
      INFO(steps << " steps of erosion, level " << level);
      CHECK(over_air == 0);
    }
  }
}

TEST_CASE("Loose material does not end in a wall next to an entrance") {
  const World world = test::small_caves(2);
  Terrain terrain;
  Generator{world}.generate({-96, -96, kSide, kSide, Lod{}}, terrain);
  int beside = 0;
  for (int z = 0; z < kSide; ++z) {
    for (int x = 1; x < kSide; ++x) {
      for (const int open : {x - 1, x}) {
        const bool opens =
            terrain.caves.has(open, z) && terrain.caves.roof.at(open, z) == terrain.surface.at(open, z);
        if (!opens) continue;
        ++beside;
        for (std::size_t m = 0; m < terrain.loose.size(); ++m) {
          CHECK(terrain.loose[m].at(open, z) == 0);
          CHECK(terrain.loose[m].at(2 * x - 1 - open, z) <= world.loose()[m].c_fx);
        }
      }
    }
  }
  CHECK(beside > 0);
}

TEST_CASE("Entrances are bare without a sea, and where roofs span less than loose material reaches") {
  std::string text = test::small_caves_text(2, 0);
  const std::string sea = "sea_level = 0.3\n";
  const std::string span =
      "span = 0.4";  // 16 columns; 0.05 are 2, fewer than the small world's gravel has in its halo
  text.erase(text.find(sea), sea.size());
  text.replace(text.find(span), span.size(), "span = 0.05");
  const World world = World::parse(text, "dry").value();
  const Lod lod = Lod::of(GENERATE(0, 1));
  Terrain terrain;
  Generator{world}.generate({-96, -96, kSide, kSide, lod}, terrain);
  int open = 0;
  for (int z = 0; z < kSide; ++z) {
    for (int x = 0; x < kSide; ++x) {
      const auto& air = terrain.caves;
      if (air.none() || !air.has(x, z) || air.roof.at(x, z) < terrain.surface.at(x, z)) continue;
      ++open;
      for (const Field& loose : terrain.loose) REQUIRE(loose.at(x, z) == 0);
    }
  }
  CHECK(open > 0);
}

TEST_CASE("Entrances are bare until material slides into them") {
  const World world = test::small_caves(2, 1);
  Terrain terrain;
  Generator{world}.generate({-96, -96, kSide, kSide, Lod{}}, terrain);
  int entered = 0;
  for (int z = 0; z < kSide; ++z) {
    for (int x = 0; x < kSide; ++x) {
      if (!terrain.caves.has(x, z) || terrain.caves.floor.at(x, z) != terrain.surface.at(x, z)) continue;
      for (std::size_t m = 0; m < terrain.loose.size(); ++m) {
        entered += terrain.loose[m].at(x, z) > 0 ? 1 : 0;
        CHECK(terrain.loose[m].at(x, z) <= 8 * erosion_step_fx(world.loose()[m].c_fx));
      }
    }
  }
  CHECK(entered > 0);
}

TEST_CASE("No water stands next to a cave or over one") {
  for (const int steps : {0, 8}) {
    for (const int level : {0, 1, 2}) {
      for (const std::uint64_t seed : {1U, 5U}) {
        const Place at = place(drowned_caves(seed, steps), Lod::of(level));
        const auto& v = at.voxels;
        int beside = 0;
        int water = 0;
        for (int y = 1; y < v.rows(); ++y) {
          for (int z = 1; z < kSide - 1; ++z) {
            for (int x = 1; x < kSide - 1; ++x) {
              if (v.at(x, y, z) != kWater) continue;
              ++water;
              const bool air = v.at(x - 1, y, z) == kAir || v.at(x + 1, y, z) == kAir ||
                               v.at(x, y, z - 1) == kAir || v.at(x, y, z + 1) == kAir ||
                               v.at(x, y - 1, z) == kAir;
              beside += air ? 1 : 0;
            }
          }
        }
        INFO(steps << " steps of erosion, seed " << seed << ", level " << level);
        CHECK(water > 0);
        CHECK(beside == 0);
      }
    }
  }
}

TEST_CASE("Caves take solid voxels away, and change what is loose; nothing else") {
  for (const int level : {0, 1}) {
    const Place with = place(test::small_caves(3), Lod::of(level));
    const Place without = place(test::small_world(3), Lod::of(level));
    int other = 0;
    for (int y = 0; y < with.voxels.rows(); ++y) {
      for (int z = 0; z < kSide; ++z) {
        for (int x = 0; x < kSide; ++x) {
          const MaterialId now = with.voxels.at(x, y, z);
          const MaterialId before = without.voxels.at(x, y, z);
          const bool taken = now == kAir && without.voxels.solid(x, y, z);
          const bool settled = with.voxels.solid(x, y, z) && loose(without.world, before);
          other += now == before || taken || settled ? 0 : 1;
        }
      }
    }
    CHECK(other == 0);
  }
}

TEST_CASE("The lowest row of voxels stays solid under every cave") {
  for (const int level : {0, 1, 2, 3}) {
    const Place at = place(test::small_caves(4), Lod::of(level));
    for (int z = 0; z < kSide; ++z) {
      for (int x = 0; x < kSide; ++x) {
        if (at.stacks.caves.has(x, z)) CHECK(boundary_row(at.stacks.caves.floor.at(x, z)) >= 1);
      }
    }
  }
}

TEST_CASE("A level over which a roof spans no column has no caves") {
  // 16 columns of span: one is left at level 4.
  CHECK(!place(test::small_caves(1), Lod::of(2)).stacks.caves.none());
  CHECK(place(test::small_caves(1), Lod::of(5)).stacks.caves.none());
}

TEST_CASE("Chunks outside the mixed rows of a tile with caves are uniform") {
  for (const int level : {0, 2}) {
    const Place at = place(test::small_caves(1), Lod::of(level));
    const auto first = static_cast<std::int32_t>(at.stacks.region.x / kChunkSize);
    for (std::int32_t x = first; x < first + kSide / kChunkSize; ++x) {
      const MixedRange range = mixed_range(at.world, at.stacks, x, first);
      const auto material_of = [&](std::int32_t y) {
        const Chunk chunk = extract_chunk(at.world, at.stacks, {x, y, first});
        return chunk.is_uniform() ? chunk.at({}) : kWater;
      };
      CHECK(material_of(range.first - 1) == range.below);
      CHECK(material_of(range.last + 1) == kAir);
    }
  }
}

TEST_CASE("The height of a column is where its topmost solid voxel ends") {
  for (const int steps : {0, 4}) {
    const World world = test::small_caves(1, steps);
    const Place at = place(world, Lod{});
    std::vector<BaseColumn> columns;
    for (int i = 0; i < 40 * 40; ++i)
      columns.push_back({at.stacks.region.x + i % 40 * 5, at.stacks.region.z + i / 40 * 5});
    const std::vector<std::int32_t> heights = surface_heights(world, columns);
    int lowered = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const int x = static_cast<int>(columns[i].x - at.stacks.region.x);
      const int z = static_cast<int>(columns[i].z - at.stacks.region.z);
      CHECK(heights[i] == at.stacks.ground_fx(x, z));
      CHECK(boundary_row(heights[i]) == at.voxels.ground(x, z));
      lowered += at.stacks.is_entrance(x, z) ? 1 : 0;
    }
    CHECK(lowered > 0);
  }
}

TEST_CASE("No player enters the world in an entrance") {
  CHECK(rc::check([] {
    const World world = test::small_caves(*rc::gen::arbitrary<std::uint64_t>());
    const VoxelPos feet = find_spawn(world);
    const std::int64_t chunk_x = floor_div(feet.x, kChunkSize);
    const std::int64_t chunk_z = floor_div(feet.z, kChunkSize);
    const Stacks stacks =
        generate_stacks(world, {chunk_x * kChunkSize, chunk_z * kChunkSize, kChunkSize, kChunkSize, Lod{}});
    const int x = static_cast<int>(feet.x - stacks.region.x);
    const int z = static_cast<int>(feet.z - stacks.region.z);
    const std::int32_t ground_fx = stacks.ground_fx(x, z);
    RC_ASSERT(ground_fx == stacks.tops.back().at(x, z));
    RC_ASSERT(feet.y == boundary_row(std::max(ground_fx, *world.sea_fx())));
  }));
}

}  // namespace
}  // namespace talus::terrain
