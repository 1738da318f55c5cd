// The strata of a region (thesis 3.4): layers that stack up from y = 0 and end at a limit. Private to
// core/terrain.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/vectors/aligned.h>

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
             Extent extent, Planes& planes) {
    start(xs, zs, limit_fx, extent, planes);
    while (pending()) step();
  }
  /// The same in pieces, a layer or a deformation each; all that is passed must live until pending() is
  /// false.
  void start(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, const Field& limit_fx,
             Extent extent, Planes& planes);
  [[nodiscard]] bool pending() const { return pending_; }
  /// REQUIRES pending().
  void step();

 private:
  void start_layers(const Field& limit_fx);
  void add_layer();
  /// Puts the layer on row z. Whether a column of it has not reached the limit.
  bool stack_row(std::size_t z, const LayerShape& shape, const Field& below, Field& top);
  [[nodiscard]] const float* sampled_row(std::int64_t z);
  void lift();

  const World& world_;
  std::vector<std::unique_ptr<Deformation>> deformations_;
  bool pending_ = false;
  std::span<const std::int64_t> xs_;
  std::span<const std::int64_t> zs_;
  const Field* limit_fx_ = nullptr;  // of the layers
  Extent extent_ = Extent::all;
  Planes* planes_ = nullptr;
  std::size_t deformation_ = 0;  // whose turn it is
  std::size_t layer_ = 0;
  bool full_ = false;  // every column has reached the limit
  Field lift_;         // of the strata by all deformations
  Field reach_;        // of the strata above that: the limit less the lift
  FbmRows noise_;
  bool between_rows_ = false;  // the layer's noise is drawn at some rows, and interpolated
  struct SampledRow {
    bool drawn = false;
    std::int64_t z = 0;
    AlignedVector<float> noise;
  };
  std::array<SampledRow, 2> sampled_rows_;
  const StrataKernels& kernels_;
  std::vector<std::uint8_t> open_rows_;      // 1 where a row has not reached the limit everywhere
  std::vector<std::uint8_t> open_segments_;  // and where kSegment columns of it have not
  Field ground_;                             // what the current layer lies on, where no plane holds it
};

}  // namespace talus::terrain
