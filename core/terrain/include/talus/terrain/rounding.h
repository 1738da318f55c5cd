// The one place where noise becomes an integer.
#pragma once

#include <cstdint>

namespace talus::terrain {

/// To the nearest integer, ties to even, for 0 <= value <= 2^23. Adding 2^23 leaves no bits for the
/// fraction, so the addition itself rounds; unlike lrint it needs no library and depends on no compiler flag.
[[nodiscard]] inline std::int32_t round_to_even(float value) {
  constexpr float kNoFraction = 8388608.0F;
  return static_cast<std::int32_t>((value + kNoFraction) - kNoFraction);
}

}  // namespace talus::terrain
