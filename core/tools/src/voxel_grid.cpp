#include <talus/tools/voxel_grid.h>

#include <algorithm>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/chunk.h>

namespace talus::tools {
namespace {

// Columns of all chunks that contain a column of the region.
terrain::Region whole_chunks(const terrain::Region& region) {
  const auto down = [](std::int64_t column) { return floor_div(column, kChunkSize) * kChunkSize; };
  const auto up = [](std::int64_t column) {
    return floor_div(column - 1, kChunkSize) * kChunkSize + kChunkSize;
  };
  const std::int64_t x = down(region.x);
  const std::int64_t z = down(region.z);
  return {x, z, static_cast<int>(up(region.x + region.width) - x),
          static_cast<int>(up(region.z + region.depth) - z), region.lod};
}

// Copies the part of a chunk that lies in the grid.
void copy_chunk(const Chunk& chunk, ChunkCoord coord, const terrain::Region& region, std::int32_t bottom,
                VoxelGrid& grid) {
  const VoxelPos origin = chunk_origin(coord);
  const auto clip = [](std::int64_t first, std::int64_t length) {
    return std::pair{static_cast<int>(std::max<std::int64_t>(0, -first)),
                     static_cast<int>(std::min<std::int64_t>(kChunkSize, length - first))};
  };
  const auto [from_x, to_x] = clip(origin.x - region.x, grid.width());
  const auto [from_z, to_z] = clip(origin.z - region.z, grid.depth());
  for (int z = from_z; z < to_z; ++z) {
    for (int x = from_x; x < to_x; ++x) {
      const int grid_x = static_cast<int>(origin.x - region.x) + x;
      const int grid_z = static_cast<int>(origin.z - region.z) + z;
      for (const Run& run : chunk.runs(x, z)) {
        grid.fill(grid_x, grid_z, origin.y - bottom + run.from, origin.y - bottom + run.to, run.material);
      }
    }
  }
}

}  // namespace

void VoxelGrid::fill(int x, int z, std::int64_t from, std::int64_t to, MaterialId material) {
  const auto voxels = column(x, z);
  const auto first = std::clamp<std::int64_t>(from, 0, rows_);
  const auto last = std::clamp<std::int64_t>(to, first, rows_);
  std::fill(voxels.begin() + first, voxels.begin() + last, material);
}

VoxelGrid grid_of_chunks(const terrain::World& world, const terrain::Region& region, std::int32_t bottom,
                         int rows) {
  VoxelGrid grid{region.width, rows, region.depth};
  const terrain::Region cover = whole_chunks(region);
  const terrain::Stacks stacks = generate_stacks(world, cover);
  const auto chunk_of = [](std::int64_t voxel) {
    return static_cast<std::int32_t>(floor_div(voxel, kChunkSize));
  };
  for (std::int32_t z = chunk_of(cover.z); z <= chunk_of(cover.z + cover.depth - 1); ++z) {
    for (std::int32_t x = chunk_of(cover.x); x <= chunk_of(cover.x + cover.width - 1); ++x) {
      for (std::int32_t y = chunk_of(bottom); y <= chunk_of(std::int64_t{bottom} + rows - 1); ++y) {
        const ChunkCoord coord{x, y, z};
        copy_chunk(extract_chunk(world, stacks, coord), coord, region, bottom, grid);
      }
      // The loop must not advance past the world's last chunk.
      if (x == chunk_of(cover.x + cover.width - 1)) break;
    }
    if (z == chunk_of(cover.z + cover.depth - 1)) break;
  }
  return grid;
}

RowRange RowRange::joined(RowRange other) const {
  return {std::min(lowest_ground, other.lowest_ground), std::max(highest, other.highest)};
}

RowRange rows_of_surface(const terrain::World& world, const terrain::Region& region) {
  const terrain::Stacks stacks = generate_stacks(world, region);
  const auto& heights = stacks.tops.back().values;
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  RowRange rows{terrain::boundary_row(*lowest), terrain::boundary_row(*highest)};
  if (const auto sea_fx = world.sea_fx()) {
    rows.highest = std::max(rows.highest, terrain::boundary_row(*sea_fx >> region.lod.value()));
  }
  return rows;
}

}  // namespace talus::tools
