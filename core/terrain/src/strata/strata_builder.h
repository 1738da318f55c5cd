// The strata of a region (thesis 3.4): layers that stack up from y = 0 and end at a limit. Private to
// core/terrain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include "feature.h"
#include "kernels/strata.h"
#include "noise/fbm_rows.h"
#include "strata/planes.h"

namespace talus::terrain {

/// Keeps its memory from region to region. For one thread at a time; the world must outlive it.
class StrataBuilder {
 public:
  /// Whether planes are built that bound nothing, because all below them reached the limit already.
  enum class Extent { until_full, all };

  StrataBuilder(const World& world, InstructionSet set);

  /// Adds the tops of the strata to `planes`, in subvoxels of level 0: layers of one material as one, all cut
  /// at `limit_fx`, the last plane equal to it. Columns are all (x, z) of the two lists of base columns.
  /// Where features deform them they stack up from the lift, and what of them lies under y = 0 is cut as
  /// well. Needs no other column: no halo.
  void build(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, const Field& limit_fx,
             Extent extent, Planes& planes);

 private:
  void stack(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, const Field& limit_fx,
             Extent extent, Planes& planes);

  const World& world_;
  std::vector<std::unique_ptr<Deformation>> deformations_;
  Field lift_;   // of the strata by all deformations
  Field reach_;  // of the strata above that: the limit less the lift
  FbmRows noise_;
  const StrataKernels& kernels_;
  std::vector<std::uint8_t> open_rows_;      // 1 where a row has not reached the limit everywhere
  std::vector<std::uint8_t> open_segments_;  // and where kSegment columns of it have not
  Field ground_;                             // what the current layer lies on, where no plane holds it
};

}  // namespace talus::terrain
