// fBm over many columns, row by row: the basis of sample_fbm and the generator.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/fbm.h>

#include "kernels/noise.h"

namespace talus::terrain {

/// Reuses its memory from one start() to the next; not thread-safe.
class FbmRows {
 public:
  explicit FbmRows(InstructionSet set) : kernels_{&noise_kernels(set)} {}

  /// Weights of the octaves: each half of the one before, or 1 if the caller sums by another rule.
  enum class Weights { halving, one };

  /// The following rows are of this noise over these ascending base columns.
  void start(const Fbm& fbm, std::span<const std::int64_t> xs, Weights weights = Weights::halving);

  /// The noise at (xs[i], z) for every i, valid until the next call. Cheapest close to the previous row.
  [[nodiscard]] const float* row(std::int64_t z) { return row(z, 0, width_); }
  /// Computes only `first` <= i < `last`, at those indices.
  [[nodiscard]] const float* row(std::int64_t z, std::size_t first, std::size_t last);
  /// Writes the whole row into padded memory.
  void row_into(std::int64_t z, float* noise);

  /// The summands of row(): the octaves that are not left out, each padded. Valid until the next call.
  [[nodiscard]] std::span<const OctaveRow> octaves(std::int64_t z);

 private:
  struct Octave {
    std::uint64_t seed = 0;
    float weight = 0;
    LatticeColumns columns;
    std::array<LatticeLine, 2> lines;  // on both sides of the row
    std::int64_t z_offset = 0;
    std::int64_t z = 0;       // the last row
    std::int64_t cell = 0;    // index of its cell in the lattice
    std::int64_t inside = 0;  // position in the cell, 0 to period - 1
    bool drawn = false;       // true if `lines` belong to `cell`
  };

  void set_columns(std::span<const std::int64_t> xs);
  void locate_columns(Octave& octave, int k, std::span<const std::int64_t> xs) const;
  void move_to(Octave& octave, int k, std::int64_t z);
  void draw(const Octave& octave, std::int64_t lattice_z, LatticeLine& line);

  const NoiseKernels* kernels_;
  Fbm fbm_;
  std::size_t width_ = 0;
  std::vector<std::int64_t> xs_;  // the columns of the last start()
  std::int64_t step_ = 0;         // distance of xs_ if it is the same for all, else 0
  std::size_t count_ = 0;         // octaves in use; extra elements are kept for their memory
  std::vector<Octave> octaves_;
  std::vector<OctaveRow> shares_;
  AlignedVector<float> gradients_;
  AlignedVector<float> noise_;
};

}  // namespace talus::terrain
