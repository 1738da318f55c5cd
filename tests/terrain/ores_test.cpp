#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>

#include "features/ores.h"
#include "features_of.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

const std::vector<OreKind>& ores_of(const World& world) {
  return test::feature_of<Ores>(world).kinds();
}

World world_with(std::uint64_t seed, const std::string& more) {
  return World::parse(test::small_world_text(seed) + more, "ores").value();
}

World veined_world(std::uint64_t seed) {
  return world_with(seed, test::underground_text());
}

// The same ground without its ore.
World barren_world(std::uint64_t seed) {
  const std::string text = test::underground_text();
  return world_with(seed, text.substr(0, text.find("[[veins]]")));
}

// Ore in every cube: chunks of more layers than the boundary view holds.
World rich_world(std::uint64_t seed) {
  std::string text;
  for (const char* name : {"a", "b", "c"}) {
    text += "[[veins]]\nname = \"" + std::string{name} +
            "\"\ncolour = \"#ffffff\"\nshape = \"pocket\"\nlow = 0\nhigh = 2.5\nsize = 0.2\nabundance = 1\n";
  }
  return world_with(seed, text);
}

ChunkKey any_key() {
  const Lod lod = Lod::of(*rc::gen::inRange(0, 4));
  const std::int64_t limit = chunk_limit(lod);
  const auto axis = [&] {
    return static_cast<std::int32_t>(*rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-60, 60),
                                                     rc::gen::inRange(limit - 40, limit),
                                                     rc::gen::inRange(-limit, -limit + 40)));
  };
  return {{axis(), *rc::gen::inRange(0, 3), axis()}, lod};
}

std::vector<MaterialId> voxels_of(const Chunk& chunk) {
  std::vector<MaterialId> voxels(kChunkVolume);
  chunk.copy_to(std::span<MaterialId, kChunkVolume>{voxels});
  return voxels;
}

bool is_ore(const World& world, MaterialId id) {
  return to_integer(id) >= world.materials().size() - ores_of(world).size();
}

// Bodies looked for far and wide around a chunk, by kind, the last of the spec first.
class BodiesAround {
 public:
  BodiesAround(const World& world, ChunkKey key) : key_{key} {
    const VoxelPos origin = chunk_origin(key.coord);
    const std::int64_t side = std::int64_t{kChunkSize} << key.lod.value();
    const std::int64_t x = origin.x * (1 << key.lod.value());
    const std::int64_t z = origin.z * (1 << key.lod.value());
    for (std::size_t i = ores_of(world).size(); i-- > 0;) {
      const OreKind kind = ores_of(world)[i];
      if (!kind.shows_at(key.lod)) continue;
      const std::int64_t wide = 2 * kind.size_fx / kSubvoxels + 1;
      auto& [material, lobes] = kinds_.emplace_back(kind.material, std::vector<OreLobe>{});
      add_lobes(kind, {x - wide, x + side + wide, z - wide, z + side + wide, -1'000'000, 100'000'000}, lobes);
    }
  }

  // The ore at the centres of a column's voxels.
  [[nodiscard]] std::vector<MaterialId> ore_of_column(int x, int z) const {
    const int shift = key_.lod.value();
    const VoxelPos origin = chunk_origin(key_.coord);
    std::vector<MaterialId> ore(kChunkSize, kAir);
    for (const auto& [material, lobes] : kinds_) {
      for (const OreLobe& lobe : lobes) {
        const auto span = OreRow{lobe, (origin.z + z) * (1 << shift)}.at((origin.x + x) * (1 << shift));
        if (!span) continue;
        for (int y = 0; y < kChunkSize; ++y) {
          const std::int64_t row = origin.y + y;
          if (row >= boundary_row(span->from_fx >> shift) && row < boundary_row(span->to_fx >> shift)) {
            ore[static_cast<std::size_t>(y)] = material;
          }
        }
      }
    }
    return ore;
  }

 private:
  ChunkKey key_;
  std::vector<std::pair<MaterialId, std::vector<OreLobe>>> kinds_;
};

TEST_CASE(
    "A rock voxel is ore where a body has its centre, the first of the spec's, and nothing else changes") {
  CHECK(rc::check([] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const bool rich = *rc::gen::inRange(0, 4) == 0;
    const World world = rich ? rich_world(seed) : veined_world(seed);
    const World barren = rich ? test::small_world(seed) : barren_world(seed);
    const ChunkKey key = any_key();
    const auto with = voxels_of(generate_chunk(world, key));
    const auto without = voxels_of(generate_chunk(barren, key));
    const BodiesAround bodies{world, key};
    for (int column = 0; column < kChunkArea; ++column) {
      const auto ore = bodies.ore_of_column(column % kChunkSize, column / kChunkSize);
      for (std::size_t y = 0; y < kChunkSize; ++y) {
        const std::size_t voxel = y * kChunkArea + static_cast<std::size_t>(column);
        const bool rock = world.materials()[to_integer(without[voxel])].kind == MaterialKind::stratified;
        RC_ASSERT(with[voxel] == (rock && ore[y] != kAir ? ore[y] : without[voxel]));
      }
    }
  }));
}

TEST_CASE("Ore lies between the heights of its kind, and most kinds are met with") {
  const World world = veined_world(4);
  std::map<std::uint16_t, int> voxels;
  const Stacks stacks = generate_stacks(world, {0, 0, 512, 512, Lod{}});
  for (std::int32_t i = 0; i < 256 * 4; ++i) {
    const ChunkCoord coord{i % 16, i / 256, i / 16 % 16};
    const Chunk chunk = extract_chunk(world, stacks, coord);
    for (int column = 0; column < kChunkArea; ++column) {
      for (const Run& run : chunk.runs(column % kChunkSize, column / kChunkSize)) {
        if (!is_ore(world, run.material)) continue;
        const std::size_t first_ore = world.materials().size() - ores_of(world).size();
        const OreKind kind = ores_of(world)[to_integer(run.material) - first_ore];
        voxels[to_integer(run.material)] += run.to - run.from;
        REQUIRE(coord.y * kChunkSize + run.from >= boundary_row(kind.low_fx));
        REQUIRE(coord.y * kChunkSize + run.to <= boundary_row(kind.high_fx));
      }
    }
  }
  CHECK(voxels.size() == 3);
  for (const auto& [id, count] : voxels) CHECK(count > 200);
}

TEST_CASE("A column has the same ore from whatever box it is asked for") {
  CHECK(rc::check([] {
    const World world = veined_world(*rc::gen::arbitrary<std::uint64_t>());
    const OreKind kind = ores_of(world)[*rc::gen::inRange<std::size_t>(0, 3)];
    const std::int64_t x = *rc::gen::inRange<std::int64_t>(-(1LL << 36), 1LL << 36);
    const std::int64_t z = *rc::gen::inRange<std::int64_t>(-(1LL << 36), 1LL << 36);
    const auto spans = [&](const OreBox& box) {
      std::vector<OreLobe> lobes;
      add_lobes(kind, box, lobes);
      std::set<std::pair<std::int32_t, std::int32_t>> found;
      for (const OreLobe& lobe : lobes) {
        if (const auto span = OreRow{lobe, z}.at(x)) found.insert({span->from_fx, span->to_fx});
      }
      return found;
    };
    const auto alone = spans({x, x + 1, z, z + 1, 0, 1 << 20});
    RC_ASSERT(spans({x - 700, x + 41, z - 3, z + 900, -5000, 1 << 22}) == alone);
    for (const auto& [from, to] : alone) {
      RC_ASSERT(from >= kind.low_fx);
      RC_ASSERT(to <= kind.high_fx);
    }
  }));
}

TEST_CASE("Heights that are asked for leave out no ore of theirs") {
  CHECK(rc::check([] {
    const World world = veined_world(*rc::gen::arbitrary<std::uint64_t>());
    const OreKind kind = ores_of(world)[*rc::gen::inRange<std::size_t>(0, 3)];
    std::vector<OreLobe> lobes;
    add_lobes(kind, {0, 200, 0, 200, kind.low_fx, kind.high_fx}, lobes);
    const std::int64_t low_fx = *rc::gen::inRange<std::int64_t>(kind.low_fx, kind.high_fx);
    const std::int64_t high_fx = low_fx + *rc::gen::inRange<std::int64_t>(1, kChunkSize * kSubvoxels);
    for (const OreLobe& lobe : lobes) {
      const std::int64_t x = lobe.x_fx / kSubvoxels + *rc::gen::inRange<std::int64_t>(-20, 21);
      const std::int64_t z = lobe.z_fx / kSubvoxels + *rc::gen::inRange<std::int64_t>(-20, 21);
      const auto all = OreRow{lobe, z}.at(x);
      const auto within = OreRow{lobe, z, low_fx, high_fx}.at(x);
      if (within) RC_ASSERT(all && all->from_fx == within->from_fx && all->to_fx == within->to_fx);
      if (all && !within) RC_ASSERT(all->to_fx < low_fx || all->from_fx >= high_fx);
    }
  }));
}

TEST_CASE("A row of a lobe has ore within its reach alone") {
  CHECK(rc::check([] {
    const World world = veined_world(*rc::gen::arbitrary<std::uint64_t>());
    const OreKind kind = ores_of(world)[*rc::gen::inRange<std::size_t>(0, 3)];
    const std::int64_t far = *rc::gen::element<std::int64_t>(0, -(1LL << 36), (1LL << 36) - 200);
    std::vector<OreLobe> lobes;
    add_lobes(kind, {far, far + 200, far, far + 200, kind.low_fx, kind.high_fx}, lobes);
    const std::int64_t low_fx = *rc::gen::inRange<std::int64_t>(kind.low_fx, kind.high_fx);
    const std::int64_t high_fx = low_fx + *rc::gen::inRange<std::int64_t>(1, 4 * kChunkSize * kSubvoxels);
    for (const OreLobe& lobe : lobes) {
      const std::int64_t columns = lobe.reach_fx / kSubvoxels + 1;
      const std::int64_t middle = floor_div(lobe.x_fx, kSubvoxels);
      const std::int64_t z =
          floor_div(lobe.z_fx, kSubvoxels) + *rc::gen::inRange<std::int64_t>(-columns, columns + 1);
      OreRow row{lobe, z, low_fx, high_fx};
      const auto [from, to] = row.reach();
      for (std::int64_t x = middle - columns; x <= middle + columns; ++x) {
        if (row.at(x)) RC_ASSERT(from <= x && x < to);
      }
    }
  }));
}

TEST_CASE("As many cubes hold a body as abundance says") {
  for (const double abundance : {0.05, 0.4, 1.0}) {
    const std::string more =
        "[[veins]]\nname = \"tin\"\ncolour = \"#ffffff\"\nshape = \"vein\"\nlow = 0\nhigh = 500\n"
        "size = 0.4\nthickness = 0.05\nabundance = " +
        std::to_string(abundance) + "\n";
    const World world = world_with(8, more);
    const OreKind kind = ores_of(world)[0];
    constexpr std::int64_t kCubes = 24;
    const std::int64_t side = kCubes * kind.size_fx / kSubvoxels;
    const std::int64_t from_fx = 100 * std::int64_t{kind.size_fx};
    std::vector<OreLobe> lobes;
    add_lobes(kind, {0, side, 0, side, from_fx, from_fx + kCubes * kind.size_fx}, lobes);
    std::set<std::uint64_t> seen;
    int middles = 0;
    for (const OreLobe& lobe : lobes) {  // a body's first lobe lies in its middle
      if (!seen.insert(lobe.seed).second) continue;
      const auto inside = [&](std::int64_t at, std::int64_t first) {
        return at >= first && at < first + kCubes * kind.size_fx;
      };
      if (inside(lobe.x_fx, 0) && inside(lobe.z_fx, 0) && inside(lobe.y_fx, from_fx)) ++middles;
    }
    const double cubes = std::pow(kCubes, 3);
    const double deviation = std::sqrt(cubes * abundance * (1 - abundance));
    INFO(abundance << ": " << middles << " of " << cubes);
    CHECK(std::abs(middles - cubes * abundance) <= 5 * deviation);
  }
}

TEST_CASE("Veins are thin and long, pockets are lumps") {
  const auto widths = [](const OreKind& kind) {
    std::vector<OreLobe> lobes;
    add_lobes(kind, {0, 2000, 0, 2000, 0, kind.high_fx}, lobes);
    const std::int64_t wide = kind.size_fx / kSubvoxels + 1;
    double columns = 0;
    double rows = 0;
    for (const OreLobe& lobe : lobes) {
      const std::int64_t x = lobe.x_fx / kSubvoxels;
      const std::int64_t z = lobe.z_fx / kSubvoxels;
      for (std::int64_t dz = -wide; dz <= wide; ++dz) {
        OreRow row{lobe, z + dz};
        for (std::int64_t dx = -wide; dx <= wide; ++dx) {
          const auto span = row.at(x + dx);
          if (!span) continue;
          columns += 1;
          rows += static_cast<double>(span->to_fx - span->from_fx) / kSubvoxels;
        }
      }
    }
    REQUIRE(columns > 0);
    return std::pair{columns / static_cast<double>(lobes.size()), rows / columns};
  };
  const World world = veined_world(2);
  const auto [vein_columns, vein_rows] = widths(ores_of(world)[0]);
  const auto [pocket_columns, pocket_rows] = widths(ores_of(world)[1]);
  CHECK(vein_rows < 6);
  CHECK(vein_columns > 10 * vein_rows);
  CHECK(pocket_columns < 10 * pocket_rows);
}

TEST_CASE("Bare rock shows the ore of its topmost voxel") {
  for (const int level : {0, 1}) {
    const World world = veined_world(9);
    const Stacks stacks = generate_stacks(world, {-320, 640, 320, 320, Lod::of(level)});
    const auto ore = exposed_overlays(world, stacks);
    const Field& rock = stacks.rock_top();
    int outcrops = 0;
    for (std::int32_t i = 0; i < 100; ++i) {
      for (std::int32_t y = 0; y < 4; ++y) {
        const ChunkCoord coord{-10 + i % 10, y, 20 + i / 10};
        const Chunk chunk = extract_chunk(world, stacks, coord);
        for (int column = 0; column < kChunkArea; ++column) {
          const int x = i % 10 * kChunkSize + column % kChunkSize;
          const int z = i / 10 * kChunkSize + column / kChunkSize;
          if (stacks.tops.back().at(x, z) != rock.at(x, z)) continue;
          const int row = boundary_row(rock.at(x, z)) - 1 - y * kChunkSize;
          if (row < 0 || row >= kChunkSize) continue;
          const MaterialId there =
              chunk.at({static_cast<std::uint8_t>(column % kChunkSize), static_cast<std::uint8_t>(row),
                        static_cast<std::uint8_t>(column / kChunkSize)});
          const MaterialId said = ore[static_cast<std::size_t>(z * 320 + x)];
          REQUIRE(said == (is_ore(world, there) ? there : kAir));
          outcrops += said != kAir ? 1 : 0;
        }
      }
    }
    CHECK(outcrops > 100);
  }
}

TEST_CASE("Outside its mixed range a column of ore country is uniform, and inside it ore is found") {
  CHECK(rc::check([] {
    const World world = veined_world(*rc::gen::arbitrary<std::uint64_t>());
    const ChunkKey key = any_key();
    const VoxelPos origin = chunk_origin(key.coord);
    const Stacks stacks = generate_stacks(world, {origin.x, origin.z, kChunkSize, kChunkSize, key.lod});
    const MixedRange range = mixed_range(world, stacks, key.coord.x, key.coord.z);
    for (std::int32_t y = -2; y < 6; ++y) {
      const Chunk chunk = extract_chunk(world, stacks, {key.coord.x, y, key.coord.z});
      if (y < range.first) RC_ASSERT(chunk == Chunk::uniform(range.below));
      if (y > range.last) RC_ASSERT(chunk == Chunk::uniform(kAir));
      const auto everywhere = uniform_everywhere(world, {{key.coord.x, y, key.coord.z}, key.lod});
      if (everywhere) RC_ASSERT(chunk == Chunk::uniform(*everywhere));
    }
  }));
}

TEST_CASE("Bodies smaller than a level's voxels are not there") {
  const World world = veined_world(1);
  // At 40 voxels a unit: coal 36 voxels long and 2.4 thick, gold 12 voxels, opal 4.8.
  std::string shown;
  for (int level = 0; level <= 3; ++level) {
    for (std::size_t i = 0; i < 3; ++i) shown += ores_of(world)[i].shows_at(Lod::of(level)) ? '+' : '-';
    shown += ' ';
  }
  CHECK(shown == "+++ ++- --- --- ");
}

}  // namespace
}  // namespace talus::terrain
