// The strata of a region (thesis 3.4): layers that stack up from y = 0 and end at a limit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include "bends.h"
#include "fbm_rows.h"
#include "kernels/strata.h"
#include "planes.h"

namespace talus::terrain {

/// Keeps its memory from region to region. For one thread at a time; the world must outlive it.
class LayersOfRock {
 public:
  /// Whether planes are laid that bound nothing, because all below them reached the limit already.
  enum class Extent { until_full, all };

  LayersOfRock(const World& world, InstructionSet set)
      : world_{world}, bends_{world.spec(), set}, noise_{set}, kernels_{strata_kernels(set)} {}

  /// Adds the tops of the strata to `planes`, in subvoxels of level 0: layers of one material as one, all cut
  /// at `limit_fx`, the last plane equal to it. Columns are all (x, z) of the two lists of base columns.
  /// Where they are bent they stack up from the bend, and what of them lies under y = 0 is cut as well. Needs
  /// no other column: no halo.
  void lay(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, const Field& limit_fx,
           Extent extent, Planes& planes);

 private:
  void pile(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, const Field& limit_fx,
            Extent extent, Planes& planes);

  const World& world_;
  Bends bends_;
  Field lift_;   // of the strata by folds and faults
  Field reach_;  // of the strata above that: the limit less the lift
  FbmRows noise_;
  const StrataKernels& kernels_;
  std::vector<std::uint8_t> open_rows_;      // 1 where a row has not reached the limit everywhere
  std::vector<std::uint8_t> open_segments_;  // and where kSegment columns of it have not
  Field ground_;                             // what the layer in work lies on, where no plane holds it
};

}  // namespace talus::terrain
