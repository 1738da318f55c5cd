// The ground of single columns.
#include <map>
#include <utility>

#include <talus/terrain/heights.h>

#include <talus/terrain/generator.h>
#include <talus/terrain/surface.h>

#include "feature.h"
#include "surface/ground.h"
#include "surface/surface_rows.h"

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
  for (const auto& [tile, requested] : by_tile) {
    const Region region{tile.first * kChunkSize, tile.second * kChunkSize, kChunkSize, kChunkSize, Lod{}};
    generator.generate(region, stacks);
    for (const std::size_t i : requested) {
      heights[i] = stacks.ground_fx(static_cast<int>(columns[i].x - region.x),
                                    static_cast<int>(columns[i].z - region.z));
    }
  }
  return heights;
}

// Whether a column opens to the sky takes no more to know than itself and the columns beside.
void lower_into_caves(const World& world, Carver& carver, std::span<const BaseColumn> columns,
                      std::vector<std::int32_t>& heights) {
  Ground ground{surface_of(world.spec()), instruction_set()};
  const int around = carver.entrance_halo(Lod{});
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Region column{columns[i].x, columns[i].z, 1, 1, Lod{}};
    ground.compute(column.expanded(around));
    carver.compute(column, around, 0, ground.height());
    const Field& entrances = carver.entrances();
    if (!entrances.values.empty() && entrances.values[0] != Carver::kClosed) heights[i] = entrances.values[0];
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
  if (const auto carver = make_carver(world, instruction_set())) {
    lower_into_caves(world, *carver, columns, heights);
  }
  return heights;
}

}  // namespace talus::terrain
