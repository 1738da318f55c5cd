// All voxels over a region of whole tiles, from its chunks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <talus/terrain/stacks.h>
#include <talus/terrain/world.h>

namespace talus::test {

class VoxelBlock {
 public:
  /// Rows 0 up to one in which all is air. The region's corner and size are multiples of 32 columns.
  VoxelBlock(const terrain::World& world, const terrain::Stacks& stacks);

  [[nodiscard]] int width() const { return region_.width; }
  [[nodiscard]] int depth() const { return region_.depth; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(depth()) + static_cast<std::size_t>(z)) *
               static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] MaterialId at(int x, int y, int z) const { return voxels_[index(x, y, z)]; }
  [[nodiscard]] bool solid(int x, int y, int z) const { return at(x, y, z) != kAir && at(x, y, z) != kWater; }
  /// The row over the topmost solid voxel; 0 where there is none.
  [[nodiscard]] int ground(int x, int z) const;

  /// By voxel_index: what solid voxels can be reached from row 0 through faces of solid voxels.
  [[nodiscard]] std::vector<bool> reached_from_below() const;

 private:
  terrain::Region region_;
  int rows_ = 0;
  std::vector<MaterialId> voxels_;
};

}  // namespace talus::test
