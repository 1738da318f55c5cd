#include "voxel_block.h"

#include <array>

#include <talus/terrain/extraction.h>

namespace talus::test {

VoxelBlock::VoxelBlock(const terrain::World& world, const terrain::Stacks& stacks) : region_{stacks.region} {
  const auto chunks = static_cast<std::int32_t>(highest_row(world, region_.lod) / kChunkSize + 1);
  rows_ = chunks * kChunkSize;
  voxels_.resize(region_.columns() * static_cast<std::size_t>(rows_));
  std::vector<MaterialId> voxels(kChunkVolume);
  const auto first_x = static_cast<std::int32_t>(region_.x / kChunkSize);
  const auto first_z = static_cast<std::int32_t>(region_.z / kChunkSize);
  for (int tz = 0; tz < region_.depth / kChunkSize; ++tz) {
    for (int tx = 0; tx < region_.width / kChunkSize; ++tx) {
      for (std::int32_t y = 0; y < chunks; ++y) {
        extract_chunk(world, stacks, {first_x + tx, y, first_z + tz})
            .copy_to(std::span<MaterialId, kChunkVolume>{voxels});
        for (std::size_t i = 0; i < voxels.size(); ++i) {
          const int local_x = static_cast<int>(i % kChunkSize);
          const int local_z = static_cast<int>(i / kChunkSize % kChunkSize);
          const int local_y = static_cast<int>(i / kChunkArea);
          voxels_[index(tx * kChunkSize + local_x, y * kChunkSize + local_y, tz * kChunkSize + local_z)] =
              voxels[i];
        }
      }
    }
  }
}

int VoxelBlock::ground(int x, int z) const {
  int row = rows_;
  while (row > 0 && !solid(x, row - 1, z)) --row;
  return row;
}

std::vector<bool> VoxelBlock::reached_from_below() const {
  struct Voxel {
    int x, y, z;
  };
  std::vector<bool> reached(voxels_.size());
  std::vector<Voxel> open;
  const auto reach = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= width() || y >= rows_ || z >= depth()) return;
    if (reached[index(x, y, z)] || !solid(x, y, z)) return;
    reached[index(x, y, z)] = true;
    open.push_back({x, y, z});
  };
  for (int z = 0; z < depth(); ++z) {
    for (int x = 0; x < width(); ++x) reach(x, 0, z);
  }
  while (!open.empty()) {
    const Voxel v = open.back();
    open.pop_back();
    reach(v.x - 1, v.y, v.z);
    reach(v.x + 1, v.y, v.z);
    reach(v.x, v.y - 1, v.z);
    reach(v.x, v.y + 1, v.z);
    reach(v.x, v.y, v.z - 1);
    reach(v.x, v.y, v.z + 1);
  }
  return reached;
}

}  // namespace talus::test
