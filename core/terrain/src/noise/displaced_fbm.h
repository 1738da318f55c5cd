// fBm at positions between columns, row after row.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/fbm.h>

#include "kernels/displaced.h"

namespace talus::terrain {

/// The same lattice and corners as FbmRows has; its numbers agree with those to rounding, not to the bit.
/// Keeps its memory from one start() to the next. For one thread at a time.
class DisplacedFbm {
 public:
  explicit DisplacedFbm(InstructionSet set) : kernels_{&displaced_kernels(set)} {}

  /// From here on rows are of this noise over these base columns.
  void start(const Fbm& fbm, std::span<const std::int64_t> xs);

  /// The noise at (xs[i] + reach * east[i], z + reach * south[i]), valid until the next call. Displacements
  /// are rounded to integers of subvoxels, |reach_fx * east| <= 2^22, and places of columns are integers, so
  /// that the far ends of the world are as fine as its middle. `east` and `south` are padded.
  [[nodiscard]] const float* row(std::int64_t z, const float* east, const float* south, float reach_fx);

 private:
  struct Lattice {
    std::uint64_t seed = 0;
    std::int64_t z_offset_fx = 0;
  };

  const DisplacedKernels* kernels_;
  std::size_t width_ = 0;
  std::int64_t period_fx_ = 0;
  std::vector<Lattice> lattices_;         // an octave
  std::vector<DisplacedOctave> octaves_;  // as many or more, for their memory
  DisplacedScratch scratch_;
  std::vector<float> noise_;
};

}  // namespace talus::terrain
