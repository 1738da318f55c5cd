// The one place where noise becomes an integer, and the one where subvoxels become voxel rows.
#pragma once

#include <cstdint>

namespace talus::terrain {

/// To the nearest integer, ties to even, for 0 <= value <= 2^23. Adding 2^23 leaves no bits for the
/// fraction, so the addition itself rounds; unlike lrint it needs no library and depends on no compiler flag.
[[nodiscard]] inline std::int32_t round_to_even(float value) {
  constexpr float kNoFraction = 8388608.0F;
  return static_cast<std::int32_t>((value + kNoFraction) - kNoFraction);
}

/// The first voxel row whose centre is not below a boundary: the least y with 256 y + 128 >= boundary_fx
/// (thesis 3.7).
[[nodiscard]] constexpr std::int32_t boundary_row(std::int32_t boundary_fx) {
  return (boundary_fx + 127) >> 8;
}

}  // namespace talus::terrain
