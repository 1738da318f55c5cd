// The ground of single columns, and a place to stand. Pure; any thread may call.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {

/// The ground of single base columns, in subvoxels: H, or a cave's floor where it is open to the sky. With
/// the erosion method each tile of 32 x 32 columns that holds a requested column costs a region of its own
/// with its halo.
struct BaseColumn {
  std::int64_t x = 0;
  std::int64_t z = 0;
};
[[nodiscard]] std::vector<std::int32_t> surface_heights(const World& world,
                                                        std::span<const BaseColumn> columns);

/// A dry, level place near the origin: the voxel in which feet stand, the first free one above the ground.
/// Where no ground is dry within reach, on the water.
[[nodiscard]] VoxelPos find_spawn(const World& world);

}  // namespace talus::terrain
