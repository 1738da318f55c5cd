// fBm on rotated lattices over many columns, row by row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/vectors/aligned.h>

#include "kernels/rotated.h"
#include "noise/rotated_lattice.h"

namespace talus::terrain {

struct RotatedNoise {
  std::uint64_t seed = 0;
  std::int64_t period = 0;  // wavelength of octave 0 in columns, 2^octaves to 2^24
  int octaves = 0;          // 1 to 16
  double gain = 0.5;        // octave k has weight gain^k
  int turn = 0;             // index of octave 0's angle, modulo kLatticeAngles

  /// The standard deviation of the sum.
  [[nodiscard]] double deviation() const;
  /// 1 if one octave dominates the sum, toward 0 if many octaves count alike and the sum is normally
  /// distributed: sum gain^4k / (sum gain^2k)^2, like its excess kurtosis.
  [[nodiscard]] double dominance() const;
};

/// A noise and its rise per column eastward and southward, where it is read.
struct SlopedRow {
  const float* value = nullptr;
  const float* east = nullptr;
  const float* south = nullptr;
};
struct SlopedNoise {
  float value = 0;
  float east = 0;
  float south = 0;
};

/// Reuses its memory from one start() to the next; not thread-safe.
class RotatedFbm {
 public:
  explicit RotatedFbm(InstructionSet set) : kernels_{&rotated_kernels(set)} {}

  /// The following rows are of this noise over these base columns.
  void start(const RotatedNoise& noise, std::span<const std::int64_t> xs);

  /// The sum of all octaves at (xs[i], z), or displaced from there, valid until the next call.
  [[nodiscard]] const float* row(std::int64_t z, const Displacements& displaced = {});
  [[nodiscard]] SlopedRow sloped_row(std::int64_t z, const Displacements& displaced = {});
  /// Computes only columns `first` <= i < `last`, at those indices; other columns are unchanged. `first` must
  /// be a multiple of kMaxLanes.
  [[nodiscard]] SlopedRow sloped_part(std::int64_t z, const Displacements& displaced, std::size_t first,
                                      std::size_t last);
  /// Writes octave k alone, with weight 1, to the caller's rows.
  void octave(int k, std::int64_t z, const RotatedSums& out, const Displacements& displaced = {});

 private:
  struct Octave {
    RotatedLattice lattice;
    float weight = 0;
    AlignedVector<std::uint64_t> u;  // by column, at z = 0
    AlignedVector<std::uint64_t> v;
    LaneSteps lane_steps;  // valid if columns are evenly spaced
  };

  void place(std::int64_t z);
  [[nodiscard]] RotatedOctave placed(const Octave& octave, std::int64_t z) const;

  const RotatedKernels* kernels_;
  std::size_t width_ = 0;
  std::uint64_t step_ = 0;  // distance between columns if it is the same for all, else 0
  std::size_t count_ = 0;   // octaves in use; extra elements are kept for their memory
  std::vector<Octave> octaves_;
  std::vector<RotatedOctave> placed_;
  AlignedVector<float> noise_;
  AlignedVector<float> east_;
  AlignedVector<float> south_;
};

/// The values of the noise at single columns. Immutable.
class RotatedPoints {
 public:
  explicit RotatedPoints(const RotatedNoise& noise);
  [[nodiscard]] float at(std::int64_t x, std::int64_t z) const;

 private:
  struct Octave {
    RotatedLattice lattice;
    float weight = 0;
  };
  std::vector<Octave> octaves_;
};

/// The noise at a position (east, south) of the column, in 2^-8 columns; equals sloped_row() to the bit.
[[nodiscard]] SlopedNoise sloped_rotated_fbm(const RotatedNoise& noise, std::int64_t x, std::int64_t z,
                                             std::int32_t east = 0, std::int32_t south = 0);
[[nodiscard]] inline float rotated_fbm(const RotatedNoise& noise, std::int64_t x, std::int64_t z,
                                       std::int32_t east = 0, std::int32_t south = 0) {
  return sloped_rotated_fbm(noise, x, z, east, south).value;
}

}  // namespace talus::terrain
