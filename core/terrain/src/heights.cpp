// The ground of single columns.
#include <map>
#include <utility>

#include <talus/terrain/stacks.h>
#include <talus/terrain/surface.h>

#include "caves.h"
#include "ground.h"

namespace talus::terrain {
namespace {

std::vector<std::int32_t> eroded_heights(const World& world, std::span<const BaseColumn> columns) {
  using Tile = std::pair<std::int64_t, std::int64_t>;
  const auto tile_of = [](const BaseColumn& column) {
    return Tile{floor_div(column.x, kChunkSize), floor_div(column.z, kChunkSize)};
  };
  std::map<Tile, std::vector<std::size_t>> by_tile;
  for (std::size_t i = 0; i < columns.size(); ++i) by_tile[tile_of(columns[i])].push_back(i);
  std::vector<std::int32_t> heights(columns.size());
  Generator generator{world};
  Stacks stacks;
  for (const auto& [tile, asked] : by_tile) {
    const Region region{tile.first * kChunkSize, tile.second * kChunkSize, kChunkSize, kChunkSize, Lod{}};
    generator.generate(region, stacks);
    for (const std::size_t i : asked) {
      heights[i] = stacks.ground_fx(static_cast<int>(columns[i].x - region.x),
                                    static_cast<int>(columns[i].z - region.z));
    }
  }
  return heights;
}

// Whether a column opens to the sky takes no more to know than itself and the columns beside.
void lower_into_caves(const World& world, std::span<const BaseColumn> columns,
                      std::vector<std::int32_t>& heights) {
  const InstructionSet set = instruction_set();
  Ground ground{surface_of(world.spec()), set};
  Caves caves{world, set};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Region column{columns[i].x, columns[i].z, 1, 1, Lod{}};
    ground.cover(column.grown(caves.shore()));
    caves.cover(column, caves.shore(), 0, ground.height());
    if (caves.opens(0, 0)) heights[i] = caves.floor(0, 0);
  }
}

}  // namespace

std::vector<std::int32_t> surface_heights(const World& world, std::span<const BaseColumn> columns) {
  if (world.spec().method == Method::erosion) return eroded_heights(world, columns);
  const auto rows = make_surface_rows(surface_of(world.spec()), instruction_set());
  std::vector<std::int32_t> heights(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    rows->start({&columns[i].x, 1});
    rows->row(columns[i].z, &heights[i]);
  }
  if (world.spec().caves) lower_into_caves(world, columns, heights);
  return heights;
}

}  // namespace talus::terrain
