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
  /// The same in pieces, a layer of a band of rows, all layers of a narrow one, or a deformation each; all
  /// that is passed must live until pending() is false.
  void start(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, const Field& limit_fx,
             Extent extent, Planes& planes);
  [[nodiscard]] bool pending() const { return pending_; }
  /// REQUIRES pending().
  void step();

 private:
  struct Layer {
    std::size_t plane = 0;  // layers of one material that follow each other are one
    Fbm noise;
    LayerShape shape;
    bool slow = false;  // its noise is drawn at some rows, and interpolated
  };
  /// A row's place among the lines at which slow noise is drawn.
  struct BetweenLines {
    std::size_t north = 0;
    float share = 0;  // of the way to the next; 0: on the line
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
  /// Puts `layer_` on row z. Whether a column of it has not reached the limit.
  bool stack_row(std::size_t z, std::int32_t* top);
  /// The same of slow layers, as StrataKernels::stack_between does.
  std::size_t stack_between(std::size_t z, std::span<const LinedLayer> layers);
  /// To all rows of the band, as StrataKernels::stack_inside does.
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
  const Field* limit_fx_ = nullptr;  // of the layers
  Extent extent_ = Extent::all;
  Planes* planes_ = nullptr;
  std::size_t deformation_ = 0;  // whose turn it is
  std::size_t band_ = 0;         // its first row: all its layers are stacked before the next rows
  std::size_t band_end_ = 0;
  std::size_t band_depth_ = 0;
  std::size_t layer_ = 0;
  bool near_limit_ = false;   // the next layers may be cut there
  std::int32_t room_fx_ = 0;  // from what is stacked to the limit, where it is least; while not near
  bool full_ = false;         // every column of the band has reached the limit
  std::vector<std::size_t> planes_of_bands_;  // how many each has filled
  std::size_t filled_ = 0;                    // planes that have all their rows
  Field lift_;                                // of the strata by all deformations
  Field reach_;                               // of the strata above that: the limit less the lift
  FbmRows noise_;
  std::vector<Layer> layers_;  // of the world
  std::vector<std::int64_t> lines_;
  std::vector<BetweenLines> rows_;
  bool keeps_lines_ = false;
  std::vector<LinesOfLayer> kept_;  // of all layers, or of the one whose turn it is
  const StrataKernels& kernels_;
  std::vector<std::uint8_t> open_rows_;      // 1 where a row has not reached the limit everywhere
  std::vector<std::uint8_t> open_segments_;  // and where kSegment columns of it have not
  std::vector<std::int32_t> level_;          // a row of zeros, on which the first layer lies
  std::vector<std::int32_t> under_;          // a row of what a layer lies on where that is its own plane
};

}  // namespace talus::terrain
