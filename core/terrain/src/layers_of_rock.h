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
#include "kernels/columns.h"
#include "planes.h"

namespace talus::terrain {

/// Keeps its memory from region to region. For one thread at a time; the world must outlive it.
class LayersOfRock {
 public:
  /// Whether planes are laid that bound nothing, because all below them reached the limit already.
  enum class Extent { until_full, all };

  LayersOfRock(const World& world, InstructionSet set)
      : world_{world}, bends_{world.spec(), set}, noise_{set}, kernels_{column_kernels(set)} {}

  /// Adds the tops of the strata to `planes`, in subvoxels of level 0: layers of one material as one, all cut
  /// at `limit_fx`, the last plane equal to it. Columns are all (x, z) of the two lists of base columns.
  /// Where they are bent they stack up from the bend, and what of them lies under y = 0 is cut as well. Needs
  /// no other column: no halo.
  void lay(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, const Field& limit_fx,
           Extent extent, Planes& planes);

 private:
  void pile(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, const Field& limit_fx,
            Extent extent, Planes& planes);

  /// Columns of a row that are not known to have reached the limit.
  struct Open {
    std::size_t first = 0;
    std::size_t last = 0;
    [[nodiscard]] bool none() const { return first == last; }
  };

  void raise_row(std::int64_t z, const LayerShape& shape, const std::int32_t* limit,
                 const std::int32_t* below, std::int32_t* top, std::size_t width, Open& open);

  const World& world_;
  Bends bends_;
  Field lift_;   // of the strata by folds and faults
  Field reach_;  // of the strata above that: the limit less the lift
  FbmRows noise_;
  const ColumnKernels& kernels_;
  std::vector<Open> open_;  // a row
  Field ground_;            // what the layer in work lies on, where no plane holds it
};

}  // namespace talus::terrain
