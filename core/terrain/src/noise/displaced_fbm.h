// fBm at positions between columns, row by row.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/fbm.h>

#include "kernels/displaced.h"

namespace talus::terrain {

/// Uses the lattice and corners of FbmRows; results agree to rounding, not to the bit. Reuses its memory from
/// one start() to the next; not thread-safe.
class DisplacedFbm {
 public:
  explicit DisplacedFbm(InstructionSet set) : kernels_{&displaced_kernels(set)} {}

  /// The following rows are of this noise over these base columns.
  void start(const Fbm& fbm, std::span<const std::int64_t> xs);

  /// The noise at (xs[i] + reach * east[i], z + reach * south[i]), valid until the next call. Displacements
  /// are rounded to integers of subvoxels, |reach_fx * east| <= 2^22, and positions of columns are integers,
  /// so precision is the same everywhere in the world. `east` and `south` are padded.
  [[nodiscard]] const float* row(std::int64_t z, const float* east, const float* south, float reach_fx);

 private:
  struct Lattice {
    std::uint64_t seed = 0;
    std::int64_t z_offset_fx = 0;
  };

  const DisplacedKernels* kernels_;
  std::size_t width_ = 0;
  std::int64_t period_fx_ = 0;
  std::vector<Lattice> lattices_;         // one per octave
  std::vector<DisplacedOctave> octaves_;  // extra elements are kept for their memory
  DisplacedScratch scratch_;
  std::vector<float> noise_;
};

}  // namespace talus::terrain
