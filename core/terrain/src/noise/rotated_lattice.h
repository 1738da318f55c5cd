// Value + gradient noise on a rotated lattice: what fields and the regions' shape are made of.
//
// A position in the lattice is a number of 2^-32 cells, linear in the column and computed modulo 2^64, so it
// is exact for every column, without a bound, a division or a remainder. Octaves have different angles, none
// within 11 degrees of an axis: an octave's tail lies on its own axes, and no two octaves share theirs.
//
// Gradient noise alone is 0 at each lattice point, so that high ground keeps away from them. Here a value is
// added at each corner, with the variance that makes corners and middles of cells vary alike.
#pragma once

#include <cstdint>

#include <talus/terrain/lattice_hash.h>

namespace talus::terrain {

/// One octave's lattice. A column east is (du, -dv) in it, and a column south (dv, du).
struct RotatedLattice {
  std::uint64_t du = 0;  // of 2^-32 cells; at most 2^31
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

/// Octave k of a noise of `period` columns a wavelength of octave 0, 2^(k+1) to 2^24. Its seed gives its
/// offset and its corners; `turn`, any number, its angle, and octave k's is 5 k further, of eight.
[[nodiscard]] RotatedLattice rotated_lattice(std::uint64_t octave_seed, std::int64_t period, int k, int turn);

/// From a cell's hash along an axis to the next one's, before it is mixed.
inline constexpr std::uint32_t kRotatedCellStep = 0x9E3779B9U;
/// Gradients are odd numbers of -1023 to 1023, drawn for each axis; values the sum of two odd ones of -15 to
/// 15. A sum of two is seldom far from 0 and most often near it, as gradient noise between corners is.
inline constexpr float kGradientUnit = 1.0F / 1023.0F;
inline constexpr float kValueUnit = 0.018078F;
/// The standard deviation of the noise of one octave, measured: that of its corners is sqrt(1 / 18), and it
/// is larger on the cells' edges.
inline constexpr double kRotatedDeviation = 0.25524;

/// The noise of one octave at a position of its lattice, mostly between -1 and 1; 1.55 is never exceeded. And
/// how it rises along both axes of the lattice, a cell.
struct RotatedSample {
  float value = 0;
  float along_u = 0;
  float along_v = 0;
};
[[nodiscard]] RotatedSample rotated_sample(const RotatedLattice& lattice, std::uint64_t u, std::uint64_t v);

}  // namespace talus::terrain
