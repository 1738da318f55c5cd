#include "generation/heights_task.h"

#include <catch2/catch.hpp>
#include <set>

#include <rapidcheck.h>

#include <talus/voxel/coords.h>

using namespace talus;
using namespace talus::server;

namespace {

std::int32_t height_of(const terrain::BaseColumn& column) {
  return static_cast<std::int32_t>(1000 * column.x + column.z);
}

}  // namespace

TEST_CASE("heights come in the order of the request, and each tile is made once") {
  CHECK(rc::check([] {
    std::vector<terrain::BaseColumn> columns(*rc::gen::inRange<std::size_t>(0, 60));
    for (terrain::BaseColumn& column : columns) {
      column = {*rc::gen::inRange<std::int64_t>(-100, 100), *rc::gen::inRange<std::int64_t>(-100, 100)};
    }
    HeightsTask task{nullptr, 1, columns};
    std::set<std::pair<std::int64_t, std::int64_t>> tiles;
    while (task.left() > 0) {
      const auto piece = task.next_piece();
      RC_ASSERT(!piece.empty());
      const auto tile_of = [](const terrain::BaseColumn& column) {
        return std::pair{floor_div(column.x, kChunkSize), floor_div(column.z, kChunkSize)};
      };
      RC_ASSERT(tiles.insert(tile_of(piece.front())).second);
      std::vector<std::int32_t> heights;
      for (const auto& column : piece) {
        RC_ASSERT(tile_of(column) == tile_of(piece.front()));
        heights.push_back(height_of(column));
      }
      task.add(heights);
    }
    RC_ASSERT(task.next_piece().empty());
    const auto heights = task.take_heights();
    RC_ASSERT(heights.size() == columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) RC_ASSERT(heights[i] == height_of(columns[i]));
  }));
}
