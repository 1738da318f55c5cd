#include "chunks/generation/heights_task.h"

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

std::uint8_t look_of(const terrain::BaseColumn& column) {
  return static_cast<std::uint8_t>(height_of(column) & 63);
}

float value_of(const terrain::BaseColumn& column, std::size_t field) {
  return static_cast<float>(height_of(column)) + 0.25F * static_cast<float>(field);
}

}  // namespace

TEST_CASE("heights come in the order of the request, and each tile is made once") {
  CHECK(rc::check([] {
    std::vector<terrain::BaseColumn> columns(*rc::gen::inRange<std::size_t>(0, 60));
    for (terrain::BaseColumn& column : columns) {
      column = {*rc::gen::inRange<std::int64_t>(-100, 100), *rc::gen::inRange<std::int64_t>(-100, 100)};
    }
    const HeightsQuery query{columns, *rc::gen::inRange(0, 2) == 1,
                             std::vector<std::uint8_t>(*rc::gen::inRange<std::size_t>(0, 4))};
    const std::size_t fields = query.fields.size();
    HeightsTask task{nullptr, 1, query};
    std::set<std::pair<std::int64_t, std::int64_t>> tiles;
    while (task.left() > 0) {
      const auto piece = task.next_piece();
      RC_ASSERT(!piece.columns.empty());
      RC_ASSERT((piece.looks == query.looks && piece.fields == query.fields));
      const auto tile_of = [](const terrain::BaseColumn& column) {
        return std::pair{floor_div(column.x, kChunkSize), floor_div(column.z, kChunkSize)};
      };
      RC_ASSERT(tiles.insert(tile_of(piece.columns.front())).second);
      HeightsResult found;
      for (const auto& column : piece.columns) {
        RC_ASSERT(tile_of(column) == tile_of(piece.columns.front()));
        found.heights_fx.push_back(height_of(column));
        if (query.looks) found.looks.push_back(look_of(column));
        for (std::size_t f = 0; f < fields; ++f) found.values.push_back(value_of(column, f));
      }
      task.add(found);
    }
    RC_ASSERT(task.next_piece().columns.empty());
    const HeightsResult found = task.take_found();
    RC_ASSERT(found.heights_fx.size() == columns.size());
    RC_ASSERT(found.looks.size() == (query.looks ? columns.size() : 0));
    RC_ASSERT(found.values.size() == columns.size() * fields);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      RC_ASSERT(found.heights_fx[i] == height_of(columns[i]));
      if (query.looks) RC_ASSERT(found.looks[i] == look_of(columns[i]));
      for (std::size_t f = 0; f < fields; ++f) {
        RC_ASSERT(found.values[i * fields + f] == value_of(columns[i], f));
      }
    }
  }));
}

TEST_CASE("a tile of the map is one piece, and done when it is drawn") {
  HeightsQuery query;
  query.tile = map::Tile{3, -1, 2};
  HeightsTask task{nullptr, 1, query};
  CHECK(task.left() == 256 * 256);
  CHECK(task.next_piece().tile == query.tile);
  CHECK(task.next_piece().columns.empty());
  HeightsResult found;
  found.picture = std::make_shared<const Picture>(Picture{"png"});
  task.add(found);
  CHECK(task.left() == 0);
  CHECK(task.take_found().picture->png == "png");
  HeightsTask given_up{nullptr, 2, query};
  given_up.give_up();
  CHECK(given_up.left() == 0);
}
