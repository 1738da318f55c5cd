// Visits the voxels that an edit's operations write, in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

#include <talus/edits/edit.h>

namespace talus::edits {

/// Calls visit(voxel) for each voxel of a box, both corners included; y slowest, then z, then x.
template <typename Visit>
void visit_box(VoxelPos first, VoxelPos last, Visit&& visit) {
  for (std::int64_t y = first.y; y <= last.y; ++y) {
    for (std::int64_t z = first.z; z <= last.z; ++z) {
      for (std::int64_t x = first.x; x <= last.x; ++x) visit(VoxelPos{x, y, z});
    }
  }
}

/// Highest corner for any origin, saturated at the maximum coordinate, which lies outside the world too.
[[nodiscard]] inline VoxelPos last_of(const Paste& paste) {
  const auto last = [](std::int64_t first) {
    constexpr std::int64_t kFar = kChunkSize - 1;
    return std::min(first, std::numeric_limits<std::int64_t>::max() - kFar) + kFar;
  };
  return {last(paste.origin.x), last(paste.origin.y), last(paste.origin.z)};
}

/// Calls visit(voxel, material) for each voxel that the paste writes.
template <typename Visit>
void visit_paste(const Paste& paste, Visit&& visit) {
  const auto voxels = std::make_unique<DenseVoxels>();
  paste.voxels.copy_to(*voxels);
  std::size_t index = 0;  // in visit_box() order
  visit_box(paste.origin, last_of(paste), [&](VoxelPos voxel) {
    const MaterialId material = (*voxels)[index++];
    if (paste.with_air || material != kAir) visit(voxel, material);
  });
}

/// Calls visit(voxel) for the six voxels that share a face with `voxel`, also outside of the world.
template <typename Visit>
void visit_beside(VoxelPos voxel, Visit&& visit) {
  for (const std::int64_t step : {-1, 1}) {
    visit(VoxelPos{voxel.x + step, voxel.y, voxel.z});
    visit(VoxelPos{voxel.x, voxel.y + step, voxel.z});
    visit(VoxelPos{voxel.x, voxel.y, voxel.z + step});
  }
}

/// The chunk of level 0 that holds `voxel`, and the voxel's index in it. REQUIRES: `voxel` lies in the world.
[[nodiscard]] inline ChunkCoord chunk_of(VoxelPos voxel) {
  return {static_cast<std::int32_t>(floor_div(voxel.x, kChunkSize)),
          static_cast<std::int32_t>(floor_div(voxel.y, kChunkSize)),
          static_cast<std::int32_t>(floor_div(voxel.z, kChunkSize))};
}
[[nodiscard]] inline std::uint16_t index_of(VoxelPos voxel) {
  return static_cast<std::uint16_t>(voxel_index(local_pos(voxel)));
}

}  // namespace talus::edits
