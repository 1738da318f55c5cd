// Dense voxels of a box of the world, for algorithms that need a voxel's neighbours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/voxel/material.h>

namespace talus::tools {

/// width x rows x depth voxels, x east, y up, z south, relative to the box's corner. The voxels of a column
/// are contiguous.
class VoxelGrid {
 public:
  /// A grid of air.
  VoxelGrid(int width, int rows, int depth)
      : width_{width},
        rows_{rows},
        depth_{depth},
        voxels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(depth) *
                    static_cast<std::size_t>(rows),
                kAir) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int depth() const { return depth_; }

  [[nodiscard]] std::span<const MaterialId> column(int x, int z) const {
    return {voxels_.data() + offset(x, z), static_cast<std::size_t>(rows_)};
  }
  [[nodiscard]] std::span<MaterialId> column(int x, int z) {
    return {voxels_.data() + offset(x, z), static_cast<std::size_t>(rows_)};
  }
  [[nodiscard]] MaterialId at(int x, int y, int z) const {
    return voxels_[offset(x, z) + static_cast<std::size_t>(y)];
  }
  /// Sets rows [from, to); rows outside the box are ignored.
  void fill(int x, int z, std::int64_t from, std::int64_t to, MaterialId material);

 private:
  [[nodiscard]] std::size_t offset(int x, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(rows_);
  }

  int width_;
  int rows_;
  int depth_;
  std::vector<MaterialId> voxels_;
};

[[nodiscard]] inline bool is_solid(MaterialId material) {
  return material != kAir && material != kWater;
}

/// Voxels of the chunks over `region`, at any level, from voxel row `bottom` up.
[[nodiscard]] VoxelGrid grid_of_chunks(const terrain::World& world, const terrain::Region& region,
                                       std::int32_t bottom, int rows);

/// Voxel rows that bound a region's surface.
struct RowRange {
  std::int32_t lowest_ground = 0;  // row of the first free voxel above the lowest ground
  std::int32_t highest = 0;        // row of the first free voxel above the highest ground or sea
  /// The range from the lower bottom to the higher top.
  [[nodiscard]] RowRange joined(RowRange other) const;
};
[[nodiscard]] RowRange rows_of_surface(const terrain::World& world, const terrain::Region& region);

}  // namespace talus::tools
