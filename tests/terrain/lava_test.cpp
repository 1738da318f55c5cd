// What any kind of feature must hold, shown by the fixture lava.cpp.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/surface.h>
#include <talus/voxel/codec.h>

#include "features_of.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

const std::string kLava = R"([[lava]]
name = "lava"
colour = "#ff4010"
low = -1.0
high = 1.5
spacing = 0.8
radius = 0.35
thickness = 0.4
abundance = 0.8
pool_reach = 0.4
pool_rows = 3
)";

tl::expected<World, SpecError> parsed(const std::string& text) {
  return World::parse(text, "w.toml", {}, features_with_fixture());
}

World lava_world(std::uint64_t seed, const std::string& more = "") {
  return parsed(test::small_world_text(seed) + kLava + more).value();
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = test::small_world_text(1) + kLava;
  const std::size_t at = text.find(from, text.find("[[lava]]"));
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::vector<std::byte> encoded(const Chunk& chunk) {
  std::vector<std::byte> bytes;
  encode(chunk, bytes);
  return bytes;
}

std::vector<MaterialId> voxels_of(const Chunk& chunk) {
  std::vector<MaterialId> voxels(kChunkVolume);
  chunk.copy_to(std::span<MaterialId, kChunkVolume>{voxels});
  return voxels;
}

// Whether the material is in rows first to last of a base column.
bool column_holds(const World& world, MaterialId material, std::int64_t x, std::int64_t z, std::int64_t first,
                  std::int64_t last) {
  const auto chunk_of = [](std::int64_t at) { return static_cast<std::int32_t>(floor_div(at, kChunkSize)); };
  const auto inside = [](std::int64_t at) { return static_cast<std::uint8_t>(floor_mod(at, kChunkSize)); };
  for (std::int64_t y = first; y <= last; ++y) {
    const Chunk chunk = generate_chunk(world, {{chunk_of(x), chunk_of(y), chunk_of(z)}, Lod{}});
    if (chunk.at({inside(x), inside(y), inside(z)}) == material) return true;
  }
  return false;
}

ChunkKey any_key() {
  const Lod lod = Lod::of(*rc::gen::inRange(0, 5));
  const std::int64_t limit = chunk_limit(lod);
  const auto axis = [&] {
    return static_cast<std::int32_t>(*rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-60, 60),
                                                     rc::gen::inRange(limit - 4, limit),
                                                     rc::gen::inRange(-limit, -limit + 4)));
  };
  return {{axis(), *rc::gen::inRange(-2, 4), axis()}, lod};
}

TEST_CASE("A feature's section is known where its kind is registered, and refused elsewhere") {
  const std::string text = test::small_world_text(1) + kLava;
  CHECK(parsed(text));
  const auto shipped = World::parse(text, "w.toml");
  REQUIRE_FALSE(shipped);
  CHECK_THAT(shipped.error().message, Catch::Contains("lava: unknown key; known here: seed, "));
}

TEST_CASE("A feature's wrong keys are refused with file, line, key and what would be right") {
  struct Wrong {
    std::string from;
    std::string to;
    std::string message;
  };
  // [[lava]] stands on line 56.
  const auto [from, to, message] = GENERATE(values<Wrong>({
      {"low = -1.0\n", "", "w.toml:56: lava[0].low: missing; a number is needed"},
      {"low = -1.0", "low = 2", "w.toml:60: lava[0].high: less than low"},
      {"spacing = 0.8", "spacing = 0.1", "w.toml:61: lava[0].spacing: 0.1 is out of range; "},
      {"radius = 0.35", "radius = 0.5", "w.toml:62: lava[0].radius: more than half of spacing"},
      {"name = \"lava\"", "name = \"chalk\"",
       "w.toml:57: lava[0].name: 'chalk' names another material already"},
      {"pool_rows = 3", "pool_depth = 3", "w.toml:66: lava[0].pool_depth: unknown key; known here: name, "},
  }));
  INFO(from << " -> " << to);
  const auto world = parsed(with(from, to));
  REQUIRE_FALSE(world);
  CHECK_THAT(world.error().message, Catch::StartsWith(message));
}

TEST_CASE("Every key of a feature that decides a voxel is in the fingerprint, and no name or colour") {
  const ContentHash plain = lava_world(1).fingerprint();
  CHECK(plain != test::small_world(1).fingerprint());
  CHECK(parsed(with("\"lava\"", "\"magma\"")).value().fingerprint() == plain);
  CHECK(parsed(with("#ff4010", "#ff5010")).value().fingerprint() == plain);
  const auto [from, to] = GENERATE(table<std::string, std::string>({
      {"low = -1.0", "low = -1.1"},
      {"high = 1.5", "high = 1.6"},
      {"spacing = 0.8", "spacing = 0.9"},
      {"radius = 0.35", "radius = 0.3"},
      {"thickness = 0.4", "thickness = 0.5"},
      {"abundance = 0.8", "abundance = 0.7"},
      {"pool_reach = 0.4", "pool_reach = 0.3"},
      {"pool_rows = 3", "pool_rows = 2"},
  }));
  INFO(from << " -> " << to);
  CHECK(parsed(with(from, to)).value().fingerprint() != plain);
}

TEST_CASE("A kind of feature that a world does not use moves no fingerprint") {
  for (const std::string& text : {test::small_world_text(1), test::small_caves_text(1),
                                  test::small_world_text(1) + test::underground_text()}) {
    CHECK(parsed(text).value().fingerprint() == World::parse(text, "w.toml").value().fingerprint());
  }
}

TEST_CASE("A feature changes rock, and air above hollows, and nothing else") {
  CHECK(rc::check([] {
    const std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
    const World with_lava = lava_world(seed);
    const World without = test::small_world(seed);
    const ChunkKey key = any_key();
    const auto voxels = voxels_of(generate_chunk(with_lava, key));
    const auto before = voxels_of(generate_chunk(without, key));
    const MaterialId lava = with_lava.materials().back().id;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      if (voxels[i] == before[i]) continue;
      RC_ASSERT(voxels[i] == lava);
      const MaterialKind kind = without.materials()[to_integer(before[i])].kind;
      RC_ASSERT(kind != MaterialKind::eroded);
    }
  }));
  // It is met with: under y = 0, in rock, and above the ground.
  const World world = lava_world(3);
  const MaterialId lava = world.materials().back().id;
  const Stacks stacks = generate_stacks(world, {0, 0, 256, 256, Lod{}});
  int deep = 0;
  int in_rock = 0;
  int above = 0;
  for (std::int32_t i = 0; i < 64 * 5; ++i) {
    const ChunkCoord coord{i % 8, i / 64 - 2, i / 8 % 8};
    const auto voxels = voxels_of(extract_chunk(world, stacks, coord));
    for (std::size_t v = 0; v < voxels.size(); ++v) {
      if (voxels[v] != lava) continue;
      const int x = coord.x * kChunkSize + static_cast<int>(v % kChunkSize);
      const int z = coord.z * kChunkSize + static_cast<int>(v / kChunkSize % kChunkSize);
      const int row = coord.y * kChunkSize + static_cast<int>(v / kChunkArea);
      deep += row < 0 ? 1 : 0;
      above += row >= boundary_row(stacks.tops.back().at(x, z)) ? 1 : 0;
      in_rock += row >= 0 && row < boundary_row(stacks.rock_top().at(x, z)) ? 1 : 0;
    }
  }
  CHECK(deep > 1000);
  CHECK(in_rock > 1000);
  CHECK(above > 30);
}

TEST_CASE("A chunk with a feature has the same bytes alone and from any larger patch, at every level") {
  CHECK(rc::check([] {
    const std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
    const std::string more = *rc::gen::element<std::string>("", test::underground_text());
    const World world = lava_world(seed, more);
    const ChunkKey key = any_key();
    const VoxelPos origin = chunk_origin(key.coord);
    const Region patch{origin.x - std::int64_t{*rc::gen::inRange(0, 3)} * kChunkSize,
                       origin.z - std::int64_t{*rc::gen::inRange(0, 3)} * kChunkSize, 3 * kChunkSize,
                       3 * kChunkSize, key.lod};
    RC_ASSERT(encoded(generate_chunk(world, key)) ==
              encoded(extract_chunk(world, generate_stacks(world, patch), key.coord)));
  }));
}

TEST_CASE("A survey is exact with the feature's halo, and not with less") {
  const World world = lava_world(5);
  for (int level = 0; level <= 1; ++level) {
    const Lod lod = Lod::of(level);
    const int reach = 16 >> level;  // 0.4 of 40 voxels: more than loose material needs
    CHECK(world.feature_halo(lod) == reach);
    CHECK(halo_columns(test::small_world(5), lod) < reach);
    CHECK(halo_columns(world, lod) == reach);
    const Region whole{-128, -128, 256, 256, lod};
    const Stacks plane = generate_stacks(world, whole);
    const auto mismatches = [&](int halo) {
      const Feature& lava = *world.features().front();
      int differing = 0;
      for (int tile = 0; tile < 16; ++tile) {
        const Region region{tile % 4 * 64 - 128, tile / 4 * 64 - 128, 64, 64, lod};
        const Region around = region.expanded(halo);
        const std::int64_t step = std::int64_t{1} << level;
        std::vector<std::int64_t> xs;
        std::vector<std::int64_t> zs;
        for (int i = 0; i < around.width; ++i) {
          xs.push_back((around.x + i) * step);
          zs.push_back((around.z + i) * step);
        }
        Field height{around.width, around.depth};
        sample_surface(surface_of(world.spec()), xs, zs, height.values);
        Field survey{64, 64};
        lava.survey(region, halo, height, survey);
        for (int z = 0; z < 64; ++z) {
          for (int x = 0; x < 64; ++x) {
            const int px = tile % 4 * 64 + x;
            const int pz = tile / 4 * 64 + z;
            differing += survey.at(x, z) != plane.surveys.front().at(px, pz) ? 1 : 0;
          }
        }
      }
      return differing;
    };
    CHECK(mismatches(reach) == 0);
    CHECK(mismatches(reach - 2) > 0);
  }
}

TEST_CASE("Outside of what a feature's rows say every chunk is uniform, under y = 0 and above the ground") {
  CHECK(rc::check([] {
    const World world = lava_world(*rc::gen::arbitrary<std::uint64_t>());
    const ChunkKey key = any_key();
    const VoxelPos origin = chunk_origin(key.coord);
    const Stacks stacks = generate_stacks(world, {origin.x, origin.z, kChunkSize, kChunkSize, key.lod});
    const MixedRange range = mixed_range(world, stacks, key.coord.x, key.coord.z);
    const HeightRange heights = height_range(world);
    for (std::int32_t y = -4; y < 6; ++y) {
      const ChunkKey here{{key.coord.x, y, key.coord.z}, key.lod};
      const Chunk chunk = extract_chunk(world, stacks, here.coord);
      if (y < range.first) RC_ASSERT(chunk == Chunk::uniform(range.below));
      if (y > range.last) RC_ASSERT(chunk == Chunk::uniform(kAir));
      const auto everywhere = uniform_everywhere(world, here);
      if (everywhere) RC_ASSERT(chunk == Chunk::uniform(*everywhere));
      const std::int64_t base = (std::int64_t{y} * kChunkSize) << key.lod.value();
      const std::int64_t rows = std::int64_t{kChunkSize} << key.lod.value();
      if (base + rows <= heights.low) RC_ASSERT(chunk == Chunk::uniform(range.below));
      if (base >= heights.high) RC_ASSERT(chunk == Chunk::uniform(kAir));
    }
  }));
  CHECK(height_range(lava_world(1)).low < -40);
  CHECK(height_range(test::small_world(1)).low == 0);
}

TEST_CASE("At a level a feature is level 0's at the base columns, until it is thinner than a voxel") {
  const World world = lava_world(3);
  const MaterialId lava = world.materials().back().id;
  // 16 voxels thick in the middle: from level 5 on less than a voxel.
  for (const int level : {1, 2, 3, 5}) {
    INFO("level " << level);
    const int step = 1 << level;
    constexpr int kTiles = 4;
    const Stacks far =
        generate_stacks(world, {0, 0, kTiles * kChunkSize, kTiles * kChunkSize, Lod::of(level)});
    int shown = 0;
    for (std::int32_t tile = 0; tile < kTiles * kTiles; ++tile) {
      const ChunkCoord coord{tile % kTiles, -1, tile / kTiles};
      const auto voxels = voxels_of(extract_chunk(world, far, coord));
      for (std::size_t v = 0; v < voxels.size(); ++v) {
        if (voxels[v] != lava || ++shown % 100 != 1) continue;
        // Some voxel of the base column within the coarse one is lava too.
        const auto base = [&](std::int64_t chunk, std::size_t inside) {
          return (chunk * kChunkSize + static_cast<std::int64_t>(inside)) * step;
        };
        const std::int64_t row = base(coord.y, v / kChunkArea);
        CHECK(column_holds(world, lava, base(coord.x, v % kChunkSize),
                           base(coord.z, v / kChunkSize % kChunkSize), row - 1, row + step));
      }
    }
    CHECK((shown > 0) == (level < 5));
  }
}

TEST_CASE("The top of the rock that a feature reports is in its chunks") {
  const World world = lava_world(3);
  const Stacks stacks = generate_stacks(world, {0, 0, 256, 256, Lod{}});
  const auto exposed = exposed_overlays(world, stacks);
  int shown = 0;
  for (std::size_t i = 0; i < exposed.size(); ++i) {
    const int x = static_cast<int>(i) % 256;
    const int z = static_cast<int>(i) / 256;
    if (exposed[i] == kAir) continue;
    ++shown;
    if (shown % 50 != 0) continue;
    const int row = boundary_row(stacks.rock_top().at(x, z)) - 1;
    const ChunkCoord coord{x / kChunkSize, static_cast<std::int32_t>(floor_div(row, kChunkSize)),
                           z / kChunkSize};
    CHECK(extract_chunk(world, stacks, coord)
              .at({static_cast<std::uint8_t>(x % kChunkSize),
                   static_cast<std::uint8_t>(floor_mod(row, kChunkSize)),
                   static_cast<std::uint8_t>(z % kChunkSize)}) == exposed[i]);
  }
  CHECK(shown > 200);
}

}  // namespace
}  // namespace talus::terrain
