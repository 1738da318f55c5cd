// fBm on rotated lattices over many columns, row after row.
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
  std::int64_t period = 0;  // columns a wavelength of octave 0, 2^octaves to 2^24
  int octaves = 0;          // 1 to 16
  double gain = 0.5;        // octave k counts gain^k
  int turn = 0;             // where its angles begin

  /// The standard deviation of the sum.
  [[nodiscard]] double deviation() const;
  /// How far the sum's distribution is that of one octave: 1 where there is but one, toward 0 where many
  /// count alike, as the sum is normally distributed then. sum gain^4k / (sum gain^2k)^2, as its excess
  /// kurtosis.
  [[nodiscard]] double dominance() const;
};

/// A noise, and how it rises a column eastward and southward at the place where it is read.
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

/// Keeps its memory from one start() to the next. For one thread at a time.
class RotatedFbm {
 public:
  explicit RotatedFbm(InstructionSet set) : kernels_{&rotated_kernels(set)} {}

  /// From here on rows are of this noise over these base columns.
  void start(const RotatedNoise& noise, std::span<const std::int64_t> xs);

  /// The sum of all octaves at (xs[i], z), or displaced from there, valid until the next call.
  [[nodiscard]] const float* row(std::int64_t z, const Displacements& displaced = {});
  [[nodiscard]] SlopedRow sloped_row(std::int64_t z, const Displacements& displaced = {});
  /// The same of columns `first` <= i < `last` alone, at those indices; `first` a multiple of kMaxLanes, and
  /// of others what it was.
  [[nodiscard]] SlopedRow sloped_part(std::int64_t z, const Displacements& displaced, std::size_t first,
                                      std::size_t last);
  /// Octave k alone, by weight 1, into rows of the caller's.
  void octave(int k, std::int64_t z, const RotatedSums& out, const Displacements& displaced = {});

 private:
  struct Octave {
    RotatedLattice lattice;
    float weight = 0;
    AlignedVector<std::uint64_t> u;  // of each column at z = 0
    AlignedVector<std::uint64_t> v;
    LaneSteps lane_steps;  // where columns are evenly spaced
  };

  void place(std::int64_t z);
  [[nodiscard]] RotatedOctave placed(const Octave& octave, std::int64_t z) const;

  const RotatedKernels* kernels_;
  std::size_t width_ = 0;
  std::uint64_t step_ = 0;  // from one column to the next, where it is the same everywhere; else 0
  std::size_t count_ = 0;   // octaves in use; more may be kept for their memory
  std::vector<Octave> octaves_;
  std::vector<RotatedOctave> placed_;
  AlignedVector<float> noise_;
  AlignedVector<float> east_;
  AlignedVector<float> south_;
};

/// The same at single columns, value alone. Immutable.
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

/// The same at one position that is (east, south) of the column by 2^-8 columns: as sloped_row() to the bit.
[[nodiscard]] SlopedNoise sloped_rotated_fbm(const RotatedNoise& noise, std::int64_t x, std::int64_t z,
                                             std::int32_t east = 0, std::int32_t south = 0);
[[nodiscard]] inline float rotated_fbm(const RotatedNoise& noise, std::int64_t x, std::int64_t z,
                                       std::int32_t east = 0, std::int32_t south = 0) {
  return sloped_rotated_fbm(noise, x, z, east, south).value;
}

}  // namespace talus::terrain
