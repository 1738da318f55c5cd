// The strata of a region (thesis 3.4): layers that stack up from y = 0 to a limit. Private to core/terrain.
#pragma once

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

/// Reuses its memory from region to region. Not thread-safe; the world must outlive it.
class StrataBuilder {
 public:
  /// `until_full` omits planes that lie completely at the limit, as lower ones have reached it.
  enum class Extent { until_full, all };

  StrataBuilder(const World& world, InstructionSet set);

  /// Adds the tops of the strata to `planes`, in subvoxels of level 0: adjacent layers of one material as
  /// one, all cut at `limit_fx`, which the last plane equals. Columns are all (x, z) of the two lists of base
  /// columns. With deformations the layers stack up from the lift, and are cut at y = 0 too. Reads no other
  /// columns, so it needs no halo.
  void build(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, const Field& limit_fx,
             Extent extent, Planes& planes) {
    start(xs, zs, limit_fx, extent, planes);
    while (pending()) step();
  }
  /// build() in pieces: a layer of a band of rows, all layers of a narrow band, or a deformation each. All
  /// arguments must live until pending() is false.
  void start(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, const Field& limit_fx,
             Extent extent, Planes& planes);
  [[nodiscard]] bool pending() const { return pending_; }
  /// REQUIRES pending().
  void step();

 private:
  struct Layer {
    std::size_t plane = 0;  // adjacent layers of one material share one
    Fbm noise;
    LayerShape shape;
    bool slow = false;  // true if its noise is drawn at some rows and interpolated
  };
  /// A row's position among the lines at which slow noise is drawn.
  struct BetweenLines {
    std::size_t north = 0;
    float share = 0;  // distance to the line as a share of the step to the next; 0: on the line
  };
  /// A slow layer's noise at all lines.
  struct LinesOfLayer {
    bool drawn = false;
    AlignedVector<float> noise;
    AlignedVector<float> rise;  // from each line to the next
  };

  void find_lines();
  void start_layers(const Field& limit_fx);
  void start_band(std::size_t first);
  void step_band();
  void add_layer();
  void add_layers();
  bool add_inside();
  [[nodiscard]] std::span<const LinedLayer> lined_layers(LinedLayer* memory, std::size_t count);
  [[nodiscard]] std::int32_t* plane_of(std::size_t layer);
  void draw_lines(std::size_t layer, LinesOfLayer& lines);
  [[nodiscard]] LinedLayer lined_layer(std::size_t layer, const LinesOfLayer& lines, std::int32_t* top) const;
  [[nodiscard]] const std::int32_t* under(std::size_t z);
  [[nodiscard]] std::uint8_t* open_of(std::size_t z);
  /// Stacks `layer_` on row z. Returns true if a column has not reached the limit.
  bool stack_row(std::size_t z, std::int32_t* top);
  /// Stacks slow layers on row z; returns StrataKernels::stack_between's result.
  std::size_t stack_between(std::size_t z, std::span<const LinedLayer> layers);
  /// Stacks layers on all rows of the band, as StrataKernels::stack_inside does.
  std::int32_t stack_inside(std::span<const LinedLayer> layers);
  [[nodiscard]] RowBetween row_between(std::size_t z) const;
  void drop_planes();
  void fill_plane(std::size_t plane);
  void lift();

  const World& world_;
  std::vector<std::unique_ptr<Deformation>> deformations_;
  bool pending_ = false;
  std::span<const std::int64_t> xs_;
  std::span<const std::int64_t> zs_;
  const Field* limit_fx_ = nullptr;  // the layers' limit
  Extent extent_ = Extent::all;
  Planes* planes_ = nullptr;
  std::size_t deformation_ = 0;  // next deformation
  std::size_t band_ = 0;         // first row of the band; all its layers are stacked before the next band
  std::size_t band_end_ = 0;
  std::size_t band_depth_ = 0;
  std::size_t layer_ = 0;
  bool near_limit_ = false;   // true if the limit may cut the next layers
  std::int32_t room_fx_ = 0;  // minimum distance from the stacked layers to the limit; valid if !near_limit_
  bool full_ = false;         // true if all columns of the band have reached the limit
  std::vector<std::size_t> planes_of_bands_;  // number of planes that each band has filled
  std::size_t filled_ = 0;                    // planes whose rows are all filled
  Field lift_;                                // sum of all deformations
  Field reach_;                               // the limit minus the lift
  FbmRows noise_;
  std::vector<Layer> layers_;  // all layers of the world
  std::vector<std::int64_t> lines_;
  std::vector<BetweenLines> rows_;
  bool keeps_lines_ = false;
  std::vector<LinesOfLayer> kept_;  // for all layers, or for the current one
  const StrataKernels& kernels_;
  std::vector<std::uint8_t> open_rows_;      // 1 if a column of the row has not reached the limit
  std::vector<std::uint8_t> open_segments_;  // the same for kSegment columns of a row
  std::vector<std::int32_t> level_;          // a row of zeros, on which the first layer lies
  std::vector<std::int32_t> under_;  // a copy of the row that a layer lies on if that is in its own plane
};

}  // namespace talus::terrain
