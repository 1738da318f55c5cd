#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <random>
#include <thread>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/codec.h>

#include "made_height_map.h"
#include "random_regions.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

using Bytes = std::vector<std::byte>;

Bytes encoded(const Chunk& chunk) {
  Bytes bytes;
  encode(chunk, bytes);
  return bytes;
}

const World& any_sample_world() {
  return test::sample_world(
      *rc::gen::element<std::string>("default", "classic", "canyon", "hills", "features"));
}

// Anywhere, around 0, and within a few chunks of either end of the world.
std::int32_t any_chunk_axis(Lod lod) {
  const std::int64_t limit = chunk_limit(lod);
  return static_cast<std::int32_t>(*rc::gen::oneOf(
      rc::gen::inRange<std::int64_t>(-limit, limit), rc::gen::inRange<std::int64_t>(-3, 3),
      rc::gen::inRange<std::int64_t>(limit - 4, limit), rc::gen::inRange<std::int64_t>(-limit, -limit + 4)));
}

ChunkKey any_key(const World& world) {
  const Lod lod = Lod::of(*rc::gen::inRange(0, Lod::kMax + 1));
  const auto rows = static_cast<std::int32_t>((height_range(world).high >> lod.value()) / kChunkSize);
  return {{any_chunk_axis(lod), *rc::gen::inRange(-1, rows + 1), any_chunk_axis(lod)}, lod};
}

// Nothing where there is none, however that is said.
std::array<std::int32_t, 2> air_at(const CaveAir& caves, int x, int z) {
  if (!caves.has(x, z)) return {};
  return {caves.floor.at(x, z), caves.roof.at(x, z)};
}

// The stacks of a patch that holds the chunk's tile somewhere inside it.
Region patch_around(ChunkKey key, int tiles) {
  const VoxelPos origin = chunk_origin(key.coord);
  return {origin.x - std::int64_t{*rc::gen::inRange(0, tiles)} * kChunkSize,
          origin.z - std::int64_t{*rc::gen::inRange(0, tiles)} * kChunkSize, tiles * kChunkSize,
          tiles * kChunkSize, key.lod};
}

World eroding_world(std::uint64_t seed, int steps, const std::string& underground = "") {
  return World::parse("method = \"erosion\"\nerosion_steps = " + std::to_string(steps) + "\n" +
                          test::small_world_text(seed) + underground,
                      "eroding")
      .value();
}

// The small world with any kind of surface, by either method, with caves, or with level strata or all that
// strata can hold.
World any_small_world() {
  const std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
  if (*rc::gen::inRange(0, 3) == 0) {
    if (auto regions = World::parse(test::random_regions_text(seed), "regions")) return *std::move(regions);
  }
  const int steps = *rc::gen::inRange(0, 13);
  if (*rc::gen::inRange(0, 3) == 0) return test::small_caves(seed, std::max(0, steps - 6));
  const std::string underground = *rc::gen::arbitrary<bool>() ? test::underground_text() : "";
  if (steps > 6) return eroding_world(seed, steps - 6, underground);
  const auto surface =
      *rc::gen::element<std::string>("", "ridged", "warped", "mirror", "sea", "repeat", "blend");
  const std::string text =
      surface.empty() ? test::small_world_text(seed) : test::small_world_text(seed, surface);
  return World::parse(text + underground, "any", test::made_height_maps()).value();
}

TEST_CASE("A chunk alone has the bytes of the same chunk from any larger patch") {
  CHECK(rc::check([] {
    const World world = *rc::gen::arbitrary<bool>() ? any_sample_world() : any_small_world();
    const ChunkKey key = any_key(world);
    const Stacks patch = generate_stacks(world, patch_around(key, *rc::gen::inRange(2, 5)));
    RC_ASSERT(encoded(generate_chunk(world, key)) == encoded(extract_chunk(world, patch, key.coord)));
  }));
}

TEST_CASE("300 random worlds of regions have no seam") {
  const auto first = static_cast<std::uint64_t>(Catch::rngSeed());
  int worlds = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const std::string text = test::random_regions_text(first + i);
    const auto world = World::parse(text, "regions");
    INFO(text);
    if (!world) {
      CAPTURE(world.error().message);
      REQUIRE(world.error().message.find("more than 256 layers") != std::string::npos);
      continue;
    }
    ++worlds;
    const Lod lod = Lod::of(static_cast<int>(i % (Lod::kMax + 1)));
    const auto x = static_cast<std::int32_t>(static_cast<std::int64_t>(i * 7919 % 2000) - 1000);
    const auto z = static_cast<std::int32_t>(static_cast<std::int64_t>(i * 104729 % 2000) - 1000);
    const Region patch{std::int64_t{x} * kChunkSize, std::int64_t{z} * kChunkSize, 2 * kChunkSize, kChunkSize,
                       lod};
    const Stacks stacks = generate_stacks(*world, patch);
    const MixedRange rows = mixed_range(*world, stacks, x + 1, z);
    for (std::int32_t y = rows.first - 1; y <= rows.last + 1; ++y) {
      const ChunkKey key{{x + 1, y, z}, lod};
      CAPTURE(i, y);
      REQUIRE(encoded(generate_chunk(*world, key)) == encoded(extract_chunk(*world, stacks, key.coord)));
    }
  }
  CHECK(worlds > 200);
}

TEST_CASE("Any two overlapping regions agree on every field of every column they share") {
  CHECK(rc::check([] {
    const World world = any_small_world();
    const Lod lod = Lod::of(*rc::gen::inRange(0, Lod::kMax + 1));
    const std::int64_t x = std::int64_t{any_chunk_axis(lod)} * kChunkSize;
    const std::int64_t z = std::int64_t{any_chunk_axis(lod)} * kChunkSize;
    const Region small{x, z, *rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20), lod};
    const int ring = *rc::gen::inRange(1, 50);
    const Terrain inner = generate_terrain(world, small);
    const Terrain outer = generate_terrain(world, small.expanded(ring));
    RC_ASSERT(outer.surface.cropped(ring).values == inner.surface.values);
    RC_ASSERT(outer.slope.cropped(ring).values == inner.slope.values);
    for (std::size_t p = 0; p < inner.strata.size(); ++p) {
      RC_ASSERT(outer.strata[p].cropped(ring).values == inner.strata[p].values);
    }
    for (std::size_t m = 0; m < inner.loose.size(); ++m) {
      RC_ASSERT(outer.loose[m].cropped(ring).values == inner.loose[m].values);
    }
    for (int row = 0; row < small.depth; ++row) {
      for (int column = 0; column < small.width; ++column) {
        RC_ASSERT(air_at(outer.caves, column + ring, row + ring) == air_at(inner.caves, column, row));
      }
    }
  }));
}

// Columns of 16 x 16 tiles whose loose thickness or cave differs from the endless plane's when only `halo`
// columns of surface are read around each tile.
int mismatches(const World& world, Lod lod, int halo) {
  constexpr int kTiles = 16;
  const Region whole{-kTiles / 2 * kChunkSize, 0, kTiles * kChunkSize, kTiles * kChunkSize, lod};
  const Terrain plane = generate_terrain(world, whole);
  int differing = 0;
  Generator generator{world};
  Terrain alone;
  for (int tz = 0; tz < kTiles; ++tz) {
    for (int tx = 0; tx < kTiles; ++tx) {
      const Region tile{whole.x + tx * kChunkSize, whole.z + tz * kChunkSize, kChunkSize, kChunkSize, lod};
      generator.generate_with_halo(tile, halo, alone);
      for (std::size_t m = 0; m < alone.loose.size(); ++m) {
        for (int z = 0; z < kChunkSize; ++z) {
          for (int x = 0; x < kChunkSize; ++x) {
            differing +=
                alone.loose[m].at(x, z) != plane.loose[m].at(tx * kChunkSize + x, tz * kChunkSize + z) ? 1
                                                                                                       : 0;
          }
        }
      }
      for (int z = 0; z < kChunkSize; ++z) {
        for (int x = 0; x < kChunkSize; ++x) {
          const auto whole_air = air_at(plane.caves, tx * kChunkSize + x, tz * kChunkSize + z);
          differing += air_at(alone.caves, x, z) != whole_air ? 1 : 0;
        }
      }
    }
  }
  return differing;
}

TEST_CASE("The theorem's halo leaves no mismatch at any level") {
  for (const char* name : {"default", "classic", "canyon", "hills", "features"}) {
    const World& world = test::sample_world(name);
    for (int level = 0; level <= 2; ++level) {
      INFO(name << " at level " << level);
      CHECK(mismatches(world, Lod::of(level), std::max(1, halo_columns(world, Lod::of(level)))) == 0);
    }
  }
}

TEST_CASE("Two columns less than the theorem's halo show mismatches") {
  // Where a full column stands as far from a bare one as its material can reach: under the canyon's mesas,
  // and in rough ground.
  const World& canyon = test::sample_world("canyon");
  CHECK(mismatches(canyon, Lod{}, canyon.halo() - 2) > 0);
  const World rough = test::small_world(3);
  for (int level = 0; level <= 1; ++level) {
    INFO("level " << level);
    const Lod lod = Lod::of(level);
    CHECK(mismatches(rough, lod, halo_columns(rough, lod)) == 0);
    CHECK(mismatches(rough, lod, halo_columns(rough, lod) - 2) > 0);
  }
}

TEST_CASE("Erosion of K steps is exact with a halo of 2 K columns, and not with K + 1") {
  for (const int steps : {3, 5, 7}) {
    const World world = eroding_world(3, steps);
    for (int level = 0; level <= 2; ++level) {
      const Lod lod = Lod::of(level);
      const int steps_here = world.erosion_steps_at(lod);
      INFO(steps << " steps, " << steps_here << " at level " << level);
      CHECK(mismatches(world, lod, 2 * steps_here) == 0);
      // One step looks two columns far, which are both formulas' halo.
      if (steps_here > 1) CHECK(mismatches(world, lod, steps_here + 1) > 0);
    }
  }
}

TEST_CASE("Caves are exact with a halo of their roofs' span, and not with less") {
  // The span is 16 columns, and one more decides what water may reach; erosion of 4 steps needs 8.
  for (const int steps : {0, 4}) {
    const World world = test::small_caves(1, steps);
    for (int level = 0; level <= 1; ++level) {
      INFO(steps << " steps at level " << level);
      const Lod lod = Lod::of(level);
      const int loose_halo = halo_columns(steps == 0 ? test::small_world(1) : eroding_world(1, steps), lod);
      const int cave_halo = (16 >> level) + 1;
      CHECK(halo_columns(world, lod) == std::max(loose_halo, cave_halo));
      CHECK(mismatches(world, lod, std::max(loose_halo, cave_halo)) == 0);
      CHECK(mismatches(world, lod, cave_halo / 2) > 0);
    }
  }
}

TEST_CASE("Any number of threads in any order makes the same chunks") {
  const World& world = test::sample_world("classic");
  std::vector<ChunkKey> keys;
  for (std::int32_t i = 0; i < 48; ++i) keys.push_back({{i % 4 - 2, i / 16, i / 4 % 4 - 2}, Lod::of(i % 3)});
  std::vector<Bytes> in_order;
  for (const ChunkKey& key : keys) in_order.push_back(encoded(generate_chunk(world, key)));

  for (const unsigned threads : {1U, 2U, 5U}) {
    std::vector<std::size_t> order(keys.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), std::mt19937{threads});
    std::vector<Bytes> made(keys.size());
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> pool;
    for (unsigned t = 0; t < threads; ++t) {
      pool.emplace_back([&] {
        for (std::size_t i = next++; i < order.size(); i = next++) {
          made[order[i]] = encoded(generate_chunk(world, keys[order[i]]));
        }
      });
    }
    for (std::thread& thread : pool) thread.join();
    CHECK(made == in_order);
  }
}

TEST_CASE("Terrain at the ends of the world is as rough as at the origin") {
  const World& world = test::sample_world("classic");
  const auto mean_slope = [&](std::int64_t x) {
    const Terrain terrain = generate_terrain(world, {x, x, 256, 256, Lod{}});
    double sum = 0;
    for (const std::int32_t s : terrain.slope.values) sum += s;
    return sum / static_cast<double>(terrain.slope.values.size());
  };
  // Means over many places, since one place may be a plain and another a mountain.
  const auto mean_of = [&](std::int64_t from, std::int64_t step) {
    double sum = 0;
    for (int i = 0; i < 12; ++i) sum += mean_slope(from + i * step);
    return sum / 12;
  };
  const std::int64_t end = chunk_limit(Lod{}) * kChunkSize;
  const double here = mean_of(-6000, 1000);
  CHECK(mean_of(end - 12000, 1000) == Approx(here).epsilon(0.6));
  CHECK(mean_of(-end, 1000) == Approx(here).epsilon(0.6));
}

}  // namespace
}  // namespace talus::terrain
