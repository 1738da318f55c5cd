// Slope at a column (thesis eq. 1): the greatest height difference between it and its eight neighbours.
#pragma once

#include <cstdint>

#include <talus/terrain/field.h>

namespace talus::terrain {

/// For every column of `heights` but the outermost ring: voxels of rise per voxel of run, in 1/256.
[[nodiscard]] Field slope_inside(const Field& heights);

}  // namespace talus::terrain
