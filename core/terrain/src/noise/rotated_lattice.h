// Value + gradient noise on a rotated lattice: the noise of fields and of the regions' shape.
//
// A position in the lattice is a number of 2^-32 cells, linear in the column and computed modulo 2^64. It is
// exact for every column, without bounds, divisions or remainders. Octaves have different angles, none within
// 11 degrees of an axis: an octave's tail, the waves longer than its own, lies on its own
// axes, and no two octaves share axes.
//
// Gradient noise alone is 0 at each lattice point, which keeps high ground away from lattice points. Here a
// value is added at each corner, with the variance that makes the noise vary as much at corners as in the
// middle of cells.
#pragma once

#include <cstdint>

#include <talus/terrain/lattice_hash.h>

namespace talus::terrain {

/// One octave's lattice. A step of one column east is (du, -dv) in it, a step south (dv, du).
struct RotatedLattice {
  std::uint64_t du = 0;  // in 2^-32 cells; at most 2^31
  std::uint64_t dv = 0;
  std::uint64_t u_offset = 0;
  std::uint64_t v_offset = 0;
  std::uint32_t u_salt = 0;
  std::uint32_t v_salt = 0;

  /// du and dv in cells.
  [[nodiscard]] float u_a_column() const {
    return static_cast<float>(static_cast<double>(du) / 4294967296.0);
  }
  [[nodiscard]] float v_a_column() const {
    return static_cast<float>(static_cast<double>(dv) / 4294967296.0);
  }

  [[nodiscard]] std::uint64_t u(std::int64_t x, std::int64_t z) const {
    return du * static_cast<std::uint64_t>(x) + dv * static_cast<std::uint64_t>(z) + u_offset;
  }
  [[nodiscard]] std::uint64_t v(std::int64_t x, std::int64_t z) const {
    return du * static_cast<std::uint64_t>(z) - dv * static_cast<std::uint64_t>(x) + v_offset;
  }
};

inline constexpr int kLatticeAngles = 8;

/// Octave k of a noise whose octave 0 has a wavelength of `period` columns, 2^(k+1) to 2^24. The seed
/// determines offset and corners; `turn`, any number, the angle: octave k's index is turn + 5 k modulo 8.
[[nodiscard]] RotatedLattice rotated_lattice(std::uint64_t octave_seed, std::int64_t period, int k, int turn);

/// The difference between the unmixed hashes of adjacent cells along an axis.
inline constexpr std::uint32_t kRotatedCellStep = 0x9E3779B9U;
/// Gradients are odd numbers of -1023 to 1023, drawn per axis; values are sums of two odd numbers of -15 to
/// 15. Such a sum is most often near 0, like gradient noise between corners.
inline constexpr float kGradientUnit = 1.0F / 1023.0F;
inline constexpr float kValueUnit = 0.018078F;
/// The standard deviation of the noise of one octave, measured. At corners it is sqrt(1 / 18); it is larger
/// on the cells' edges.
inline constexpr double kRotatedDeviation = 0.25524;

/// The noise of one octave at a position of its lattice, mostly between -1 and 1 and never beyond 1.55, and
/// its rise per cell along both axes of the lattice.
struct RotatedSample {
  float value = 0;
  float along_u = 0;
  float along_v = 0;
};
[[nodiscard]] RotatedSample rotated_sample(const RotatedLattice& lattice, std::uint64_t u, std::uint64_t v);

}  // namespace talus::terrain
