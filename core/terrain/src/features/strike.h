// A strike as a direction in integers. Private to core/terrain.
#pragma once

#include <cstdint>

#include "spec/angles.h"
#include "spec/text_writer.h"
#include "spec/units.h"

namespace talus::terrain {

/// Lines along a strike have a constant `x cos + z sin`. In 2^-16, fixed when a world is read.
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
  return {rounded(cosine_of_degrees(degrees) * 65536), rounded(sine_of_degrees(degrees) * 65536)};
}

/// Formats for canonical forms.
inline TextWriter& operator<<(TextWriter& form, const Strike& strike) {
  return form << " strike_q16 " << strike.cos_q16 << ' ' << strike.sin_q16;
}

}  // namespace talus::terrain
