// Patches up to the last chunk that a coordinate can name.
#include "chunks/generation/patch.h"

#include <catch2/catch.hpp>

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "chunks/generation/column_rows.h"
#include "chunks/generation/terrain_generator.h"
#include "made_whole.h"

using namespace talus;
using namespace talus::server;

namespace {

constexpr std::int32_t kFirst = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kLast = std::numeric_limits<std::int32_t>::max();

// All that server/config accepts; settings_test.cpp holds them against is_patch_edge().
constexpr std::array kEdges{1, 2, 4, 8, 16};

/// The coordinates nearest to both ends of the world, and to the middle.
std::vector<std::int32_t> near_the_ends(int patch_tiles) {
  std::vector<std::int32_t> all;
  for (std::int32_t i = 0; i < 2 * patch_tiles; ++i) {
    for (const std::int32_t at : {kFirst + i, -i, i, kLast - i}) all.push_back(at);
  }
  return all;
}

}  // namespace

TEST_CASE("to the world's ends a patch holds the columns of its region, in their order, and no others") {
  for (const int tiles : kEdges) {
    for (const std::int32_t x : near_the_ends(tiles)) {
      const std::int32_t z = x == kFirst ? kLast : kFirst;
      const PatchKey patch = patch_of({{x, 0, z}, Lod{}}, tiles);
      const terrain::Region region = region_of(patch, tiles);
      CAPTURE(tiles, x);
      std::int64_t column_x = region.x;
      std::int64_t column_z = region.z;
      bool found = false;
      for_each_column(patch, tiles, [&](ChunkKey column) {
        REQUIRE(std::int64_t{column.coord.x} * kChunkSize == column_x);
        REQUIRE(std::int64_t{column.coord.z} * kChunkSize == column_z);
        REQUIRE(patch_of(column, tiles) == patch);
        found = found || (column.coord.x == x && column.coord.z == z);
        column_x += kChunkSize;
        if (column_x < region.x + region.width) return;
        column_x = region.x;
        column_z += kChunkSize;
      });
      REQUIRE(found);
    }
  }
}

TEST_CASE(
    "to the world's ends chunks are the same, and rows are noted under their own keys, for every edge") {
  const auto world = std::make_shared<const terrain::World>(terrain::default_world());
  const TerrainGenerator single{world, 1};
  for (const int tiles : kEdges) {
    const TerrainGenerator generator{world, tiles};
    for (const auto& [x, z] : {std::pair{kFirst, kLast}, std::pair{kLast, kFirst}, std::pair{kLast, kLast}}) {
      CAPTURE(tiles, x, z);
      const ChunkKey column{{x, 0, z}, Lod{}};
      const terrain::Stacks stacks = made_whole(generator.start_patch(patch_of(column, tiles), {}));
      ColumnRows rows{generator, tiles, 1 << 22};
      rows.note(patch_of(column, tiles), stacks);
      // The other end's, which another patch generates.
      const auto across = [](std::int32_t at) { return at == kFirst ? kLast : kFirst; };
      CHECK_FALSE(rows.exact({{across(x), 0, z}, Lod{}}).has_value());
      CHECK_FALSE(rows.exact({{x, 0, across(z)}, Lod{}}).has_value());

      const terrain::Stacks alone = made_whole(single.start_patch(patch_of(column, 1), {}));
      const MixedRows mixed = single.mixed_rows(alone, column);
      const auto noted = rows.exact(column);
      REQUIRE(noted.has_value());
      CHECK(noted->first == mixed.first);
      CHECK(noted->last == mixed.last);
      for (std::int32_t y = mixed.first; y <= mixed.last; ++y) {
        const ChunkKey key{{x, y, z}, Lod{}};
        CHECK(generator.make_chunk(stacks, key)->hash() == single.make_chunk(alone, key)->hash());
      }
    }
  }
}
