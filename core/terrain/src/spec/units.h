// Conversion of a spec's lengths to the integers used by the generator. Private to core/terrain.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <talus/terrain/world.h>

namespace talus::terrain {

/// Rounds to the nearest integer, halves up.
[[nodiscard]] inline std::int64_t rounded(double value) {
  return static_cast<std::int64_t>(std::floor(value + 0.5));
}

/// Converts 2^-16 terrain unit to subvoxels, rounded, using only integers.
[[nodiscard]] constexpr std::int64_t subvoxels_of(std::int64_t units_q16, int resolution) {
  return (units_q16 * resolution * kSubvoxels + 32768) >> 16;
}

[[nodiscard]] constexpr double units_of(std::int64_t units_q16) {
  return static_cast<double>(units_q16) / 65536;
}

}  // namespace talus::terrain
