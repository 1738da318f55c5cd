// fBm over many columns, row after row: what sample_fbm and the generator stand on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/fbm.h>

#include "kernels/noise.h"

namespace talus::terrain {

/// Keeps its memory from one start() to the next. For one thread at a time.
class FbmRows {
 public:
  explicit FbmRows(InstructionSet set) : kernels_{&noise_kernels(set)} {}

  /// How much of the sum an octave is: half of the one before, or 1 where the caller sums by another rule.
  enum class Weights { halving, one };

  /// From here on rows are of this noise over these ascending base columns.
  void start(const Fbm& fbm, std::span<const std::int64_t> xs, Weights weights = Weights::halving);

  /// The noise at (xs[i], z) for every i, valid until the next call. Rows close to the one before cost least.
  [[nodiscard]] const float* row(std::int64_t z) { return row(z, 0, width_); }
  /// The same for `first` <= i < `last` alone, at those indices.
  [[nodiscard]] const float* row(std::int64_t z, std::size_t first, std::size_t last);
  /// The whole row into padded memory.
  void row_into(std::int64_t z, float* noise);

  /// What row() sums: the octaves that are not left out, each padded. Valid until the next call.
  [[nodiscard]] std::span<const OctaveRow> octaves(std::int64_t z);

 private:
  struct Octave {
    std::uint64_t seed = 0;
    float weight = 0;
    LatticeColumns columns;
    std::array<LatticeLine, 2> lines;  // on both sides of the row
    std::int64_t z_offset = 0;
    std::int64_t z = 0;       // the last row
    std::int64_t cell = 0;    // and its place in the lattice
    std::int64_t inside = 0;  // 0 to period - 1
    bool drawn = false;       // whether `lines` are those of `cell`
  };

  void set_columns(std::span<const std::int64_t> xs);
  void locate_columns(Octave& octave, int k, std::span<const std::int64_t> xs) const;
  void move_to(Octave& octave, int k, std::int64_t z);
  void draw(const Octave& octave, std::int64_t lattice_z, LatticeLine& line);

  const NoiseKernels* kernels_;
  Fbm fbm_;
  std::size_t width_ = 0;
  std::vector<std::int64_t> xs_;  // the columns of the last start(), of which step_ is
  std::int64_t step_ = 0;         // from column to column, where it is the same everywhere
  std::size_t count_ = 0;         // octaves in use; more may be kept for their memory
  std::vector<Octave> octaves_;
  std::vector<OctaveRow> shares_;
  AlignedVector<float> gradients_;
  AlignedVector<float> noise_;
};

}  // namespace talus::terrain
