// Slope at a column (thesis eq. 1): the greatest height difference to its eight neighbours.
#pragma once

#include <cstdint>

#include <talus/terrain/field.h>

namespace talus::terrain {

/// Slope of all columns of `heights` except the outermost ring: voxels of rise per voxel of run, in 1/256.
[[nodiscard]] Field slope_inside(const Field& heights);

}  // namespace talus::terrain
