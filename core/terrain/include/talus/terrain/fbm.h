// Fractional Brownian motion of Perlin gradient noise on an integer lattice (thesis 2.1.1, 3.1).
//
// The lattice is integer, so there are no far lands: position (x << k) + o_k falls into a cell by 64-bit
// division, and only the remainder inside the cell becomes a float. All float32 operations are written in one
// fixed order without fused multiply-add, so results are bit-identical everywhere.
#pragma once

#include <cstdint>
#include <span>

namespace talus::terrain {

struct Fbm {
  std::uint64_t seed = 0;
  std::int64_t period = 0;  // P_0: wavelength of octave 0 in columns, 1 to 2^24
  int octaves = 0;          // 1 to 16; amplitudes halve with each octave and are normalised over all octaves

  /// Octave k has cells of period / 2^k columns. Octaves of less than two columns would be aliased and are
  /// left out; their share of the normalisation stays.
  [[nodiscard]] bool has_octave(int k) const { return period >= (std::int64_t{2} << k); }
};

/// Samples the noise at all (x, z) of two ascending lists of base columns, |coordinate| <= 2^36 + 2^16:
/// out[j * xs.size() + i] is at (xs[i], zs[j]), between -1 and 1. `out` has xs.size() * zs.size() values.
void sample_fbm(const Fbm& fbm, std::span<const std::int64_t> xs, std::span<const std::int64_t> zs,
                std::span<float> out);

}  // namespace talus::terrain
