// Positions in the lattice of an octave. Private to core/terrain.
#pragma once

#include <cstdint>

#include <talus/terrain/fbm.h>
#include <talus/terrain/lattice_hash.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {

/// Perlin's quintic: first and second derivatives vanish at the lattice, so slopes have no creases.
[[nodiscard]] inline float fade(float t) {
  return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F);
}

/// Its derivative.
[[nodiscard]] inline float fade_slope(float t) {
  const float both = t * (t - 1.0F);
  return 30.0F * (both * both);
}

[[nodiscard]] inline float lerp(float a, float b, float t) {
  return a + t * (b - a);
}

/// An octave's offset, 0 to period - 1, which separates its zeros from other octaves' zeros.
[[nodiscard]] inline std::int64_t offset_of(std::uint64_t octave_seed, Axis axis, std::int64_t period) {
  const std::uint64_t draw = derived_seed(octave_seed, static_cast<std::uint64_t>(axis)) >> 32;
  return static_cast<std::int64_t>((draw * static_cast<std::uint64_t>(period)) >> 32);
}

/// Octave k's weight: half of the one before; the weights of all octaves of the spec sum to 1.
[[nodiscard]] inline float octave_weight(const Fbm& fbm, int k) {
  const double all_weights = 2.0 - 2.0 / static_cast<double>(std::int64_t{1} << fbm.octaves);
  return static_cast<float>(1.0 / (static_cast<double>(std::int64_t{1} << k) * all_weights));
}

/// Moves a position in a lattice. Most moves are short, and stepping is cheaper than dividing.
inline void step_to(std::int64_t distance, std::int64_t period, std::int64_t& cell, std::int64_t& inside) {
  inside += distance;
  if (inside >= period && inside < 2 * period) {
    inside -= period;
    ++cell;
  } else if (inside < 0 || inside >= period) {
    cell += floor_div(inside, period);
    inside = floor_mod(inside, period);
  }
}

}  // namespace talus::terrain
