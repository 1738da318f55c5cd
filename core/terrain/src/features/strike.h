// A strike as a direction in integers. Private to core/terrain.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <ostream>

#include "spec/units.h"

namespace talus::terrain {

/// Lines along a strike have a constant `x cos + z sin`. In 2^-16, fixed when a world is read, so that voxels
/// do not depend on the machine's cosine.
struct Strike {
  std::int64_t cos_q16 = 0;
  std::int64_t sin_q16 = 0;

  /// Distances of a base column across the strike and along it, in 2^-16 column.
  [[nodiscard]] std::int64_t across_q16(std::int64_t x, std::int64_t z) const {
    return x * cos_q16 + z * sin_q16;
  }
  [[nodiscard]] std::int64_t along_q16(std::int64_t x, std::int64_t z) const {
    return z * cos_q16 - x * sin_q16;
  }
};

/// Converts a compass bearing: 0 is north (-z), 90 is east.
[[nodiscard]] inline Strike strike_of(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {rounded(std::cos(angle) * 65536), rounded(std::sin(angle) * 65536)};
}

/// Formats for canonical forms.
inline std::ostream& operator<<(std::ostream& form, const Strike& strike) {
  return form << " strike_q16 " << strike.cos_q16 << ' ' << strike.sin_q16;
}

}  // namespace talus::terrain
