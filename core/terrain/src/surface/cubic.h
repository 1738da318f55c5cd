// The Catmull-Rom cubic in integers.
#pragma once

#include <array>
#include <cstdint>

namespace talus::terrain {

/// A position between two samples is an integer of 2^-20.
inline constexpr int kPlaceBits = 20;
/// Weights are integers of 2^-19: the product of two of them, each at most 1.25 in absolute sum, and a height
/// below 2^23 is below 2^63.
inline constexpr int kCubicBits = 19;
inline constexpr std::int64_t kCubicOne = std::int64_t{1} << kCubicBits;

/// The weights of the samples at -1, 0, 1 and 2 for position t / 2^20 between samples 0 and 1, 0 <= t < 2^20.
/// They sum to kCubicOne exactly, so that a plateau stays level.
[[nodiscard]] constexpr std::array<std::int64_t, 4> cubic_weights(std::int64_t t) {
  const std::int64_t t1 = t << (2 * kPlaceBits);  // t1 to t3 are in 2^-60
  const std::int64_t t2 = (t * t) << kPlaceBits;
  const std::int64_t t3 = t * t * t;
  // Halves each polynomial, rounded.
  const auto weight = [](std::int64_t twice_q60) {
    constexpr int kShift = 3 * kPlaceBits + 1 - kCubicBits;
    return (twice_q60 + (std::int64_t{1} << (kShift - 1))) >> kShift;
  };
  const std::int64_t before = weight(-t3 + 2 * t2 - t1);
  const std::int64_t after = weight(-3 * t3 + 4 * t2 + t1);
  const std::int64_t last = weight(t3 - t2);
  return {before, kCubicOne - before - after - last, after, last};
}

}  // namespace talus::terrain
