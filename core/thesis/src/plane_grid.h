// Voxels of stages of the method that no chunk has.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <talus/terrain/field.h>
#include <talus/tools/voxel_grid.h>
#include <talus/voxel/material.h>

namespace talus::tools {

/// Voxels between planes laid out as in terrain::Stacks, from any source, from voxel row `bottom` up:
/// materials[k] lies below tops[k], water between the last plane and the sea.
[[nodiscard]] VoxelGrid grid_of_planes(std::span<const MaterialId> materials,
                                       std::span<const terrain::Field> tops,
                                       std::optional<std::int32_t> sea_fx, std::int32_t bottom, int rows);

}  // namespace talus::tools
