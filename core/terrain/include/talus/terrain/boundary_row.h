// The only conversion from subvoxels to voxel rows.
#pragma once

#include <cstdint>

namespace talus::terrain {

/// Returns the first voxel row whose centre is not below a boundary: the least y with
/// 256 y + 128 >= boundary_fx (thesis 3.7).
[[nodiscard]] constexpr std::int32_t boundary_row(std::int32_t boundary_fx) {
  return (boundary_fx + 127) >> 8;
}

}  // namespace talus::terrain
