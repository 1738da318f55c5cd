#include "chunks/generation/terrain_generator.h"

#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <talus/terrain/heights.h>
#include <talus/terrain/places.h>
#include <talus/voxel/codec.h>

#include "made_whole.h"

using namespace talus;
using namespace talus::server;

namespace {

constexpr int kTiles = 2;

std::shared_ptr<const terrain::World> world() {
  static const auto one = std::make_shared<const terrain::World>(terrain::default_world());
  return one;
}

/// A generator and the stacks of one of its patches.
struct Bench {
  TerrainGenerator generator{world(), kTiles};
  PatchKey patch;
  terrain::Stacks stacks;

  explicit Bench(const PatchKey& key = {3, -2, Lod{}}) : patch{key} {
    stacks = made_whole(generator.start_patch(patch, {}));
  }
  /// All chunks of the patch that are mixed, and one row more at each end.
  template <typename Visit>
  void for_each_chunk(Visit&& visit) const {
    for_each_column(patch, kTiles, [&](ChunkKey column) {
      const MixedRows rows = generator.mixed_rows(stacks, column);
      for (std::int32_t y = rows.first - 1; y <= rows.last + 1; ++y) {
        column.coord.y = y;
        visit(column, rows);
      }
    });
  }
};

}  // namespace

TEST_CASE("a chunk is the world's, encoded, with the hash of its voxels") {
  const Bench bench{{3, -2, Lod::of(GENERATE(0, 2))}};
  int chunks = 0;
  bench.for_each_chunk([&](ChunkKey key, const MixedRows&) {
    const Chunk expected = terrain::extract_chunk(*world(), bench.stacks, key.coord);
    std::vector<std::byte> payload;
    encode(expected, payload);
    const EncodedChunkPtr made = bench.generator.make_chunk(bench.stacks, key);
    CHECK(std::equal(payload.begin(), payload.end(), made->payload().begin(), made->payload().end()));
    CHECK(made->hash() == content_hash(expected));
    CHECK(made->revision() == kBaseRevision);
    ++chunks;
  });
  CHECK(chunks > 8);
}

TEST_CASE("outside a column's mixed rows a chunk is the uniform one of their material, shared") {
  const Bench bench;
  bench.for_each_chunk([&](ChunkKey key, const MixedRows& rows) {
    const auto material = rows.uniform_at(key.coord.y);
    if (!material) return;
    CHECK(bench.generator.make_chunk(bench.stacks, key) == bench.generator.uniform(*material));
  });
}

TEST_CASE("facts about every column hold for a patch's columns") {
  const Bench bench;
  const MixedRows anywhere = bench.generator.mixed_rows_anywhere(Lod{});
  for_each_column(bench.patch, kTiles, [&](ChunkKey column) {
    const MixedRows rows = bench.generator.mixed_rows(bench.stacks, column);
    CHECK(rows.first >= anywhere.first);
    CHECK(rows.last <= anywhere.last);
    CHECK(rows.below == anywhere.below);
  });
}

TEST_CASE("a chunk is known at once if and only if its row is uniform everywhere") {
  const TerrainGenerator generator{world(), kTiles};
  const MixedRows anywhere = generator.mixed_rows_anywhere(Lod{});
  for (std::int32_t y = anywhere.first - 2; y <= anywhere.last + 2; ++y) {
    const auto material = anywhere.uniform_at(y);
    const EncodedChunkPtr instant = generator.instant({{5, y, 7}, Lod{}});
    CHECK(instant == (material ? generator.uniform(*material) : nullptr));
  }
}

TEST_CASE("every level has its own rows that are uniform everywhere") {
  const TerrainGenerator generator{world(), kTiles};
  for (int level = 0; level <= Lod::kMax; ++level) {
    const Lod lod = Lod::of(level);
    const MixedRows rows = generator.mixed_rows_anywhere(lod);
    const terrain::MixedRange range = terrain::mixed_range(*world(), lod);
    CHECK(rows.first == range.first);
    CHECK(rows.last == range.last);
    const ChunkKey over{{0, range.last + 1, 0}, lod};
    CHECK(generator.instant(over) == generator.uniform(kAir));
    CHECK(generator.instant({{0, range.last, 0}, lod}) == nullptr);
  }
}

TEST_CASE("every material of the world has its uniform chunk") {
  const TerrainGenerator generator{world(), kTiles};
  for (const terrain::Material& material : world()->materials()) {
    const auto decoded = decode(generator.uniform(material.id)->payload());
    REQUIRE(decoded.has_value());
    CHECK(decoded->is_uniform());
    CHECK(decoded->at({}) == material.id);
  }
}

TEST_CASE("a patch made in the memory of another is the same, on any thread") {
  const Bench expected;
  const TerrainGenerator generator{world(), kTiles};
  std::vector<std::vector<EncodedChunkPtr>> made(4);
  std::vector<std::thread> threads;
  for (auto& mine : made) {
    threads.emplace_back([&] {
      terrain::Stacks stacks;
      for (const std::int32_t x : {100, 3}) {
        stacks = made_whole(generator.start_patch({x, -2, Lod{}}, std::move(stacks)));
      }
      expected.for_each_chunk(
          [&](ChunkKey key, const MixedRows&) { mine.push_back(generator.make_chunk(stacks, key)); });
    });
  }
  for (std::thread& thread : threads) thread.join();
  std::size_t index = 0;
  expected.for_each_chunk([&](ChunkKey key, const MixedRows&) {
    const EncodedChunkPtr chunk = expected.generator.make_chunk(expected.stacks, key);
    for (const auto& mine : made) CHECK(mine.at(index)->hash() == chunk->hash());
    ++index;
  });
}

TEST_CASE("heights are the surface's") {
  const TerrainGenerator generator{world(), kTiles};
  const std::vector<terrain::BaseColumn> columns{{0, 0}, {1000, -77}, {-31, 32}};
  const HeightsResult found = made_whole(generator.start_heights({columns}));
  CHECK(found.heights_fx == terrain::surface_heights(*world(), columns));
  CHECK(found.looks.empty());
  CHECK(found.values.empty());
}

TEST_CASE("looks and fields match the places") {
  const terrain::World& land = *world();
  const TerrainGenerator generator{world(), kTiles};
  std::mt19937_64 random{20'261'123};
  std::vector<terrain::BaseColumn> columns;
  for (int i = 0; i < 300; ++i) {
    const auto some = [&] { return static_cast<std::int64_t>(random() % 200) - 100; };
    const std::int64_t x = some() * (i % 3 == 0 ? 1000 : 1);
    columns.push_back({x, some()});
  }
  const std::vector<std::string> names = terrain::place_names(land);
  REQUIRE(names.size() > 3);
  const std::vector<std::uint8_t> fields{3, 0, static_cast<std::uint8_t>(names.size() - 1)};
  const std::vector<std::string> asked{names[3], names[0], names.back()};
  const HeightsResult found = made_whole(generator.start_heights({columns, true, fields}));
  CHECK(found.heights_fx == terrain::surface_heights(land, columns));
  REQUIRE(found.looks.size() == columns.size());
  REQUIRE(found.values.size() == columns.size() * fields.size());
  // One column at a time, by a sampler that was at another one before.
  auto sampler = terrain::PlaceSampler::make(land, asked).value();
  std::set<int> looks;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    sampler.start({&columns[i].x, 1});
    sampler.row(columns[i].z);
    CHECK(found.looks[i] == sampler.looks()[0]);
    looks.insert(found.looks[i]);
    for (std::size_t f = 0; f < fields.size(); ++f) {
      CHECK(found.values[i * fields.size() + f] == sampler.values(f)[0]);
    }
  }
  CHECK(looks.size() > 3);
}

TEST_CASE("a patch that is given up or waits halfway leaves the next patch right") {
  const TerrainGenerator generator{world(), kTiles};
  const PatchKey patch{3, -2, Lod{}};
  const auto given_up = generator.start_patch(patch, {});
  for (int i = 0; i < 3; ++i) REQUIRE(given_up->step());
  // While it waits, or is gone, others are made.
  const auto waiting = generator.start_patch(patch, {});
  REQUIRE(waiting->step());
  const terrain::Stacks again = made_whole(generator.start_patch(patch, {}));
  CHECK((again.tops.back().values == Bench{}.stacks.tops.back().values));
  while (waiting->step()) continue;
  CHECK((waiting->take().tops.back().values == again.tops.back().values));
  std::vector<terrain::BaseColumn> columns;  // of many tiles
  for (std::int64_t i = 0; i < 512; ++i) columns.push_back({i * 64, 0});
  CHECK(generator.start_heights({columns})->step());
}
