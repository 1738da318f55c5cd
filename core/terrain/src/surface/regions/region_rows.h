// The surface "regions", row by row.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <talus/vectors/aligned.h>

#include "kernels/places.h"
#include "kernels/regions.h"
#include "noise/fbm_rows.h"
#include "noise/rotated_fbm.h"
#include "surface/regions/column_spread.h"
#include "surface/regions/regions.h"
#include "surface/regions/slow_lines.h"
#include "surface/surface_rows.h"

namespace talus::terrain {

class RegionRows final : public SurfaceRows {
 public:
  RegionRows(const Surface& surface, InstructionSet set);

  void start(std::span<const std::int64_t> xs) override;
  void row(std::int64_t z, std::int32_t* heights_fx) override;
  [[nodiscard]] bool knows_slopes() const override { return true; }
  [[nodiscard]] bool starts_level(std::span<const std::int64_t> xs, Lod lod) override;
  void sloped_row(std::int64_t z, std::int32_t* heights_fx, std::int32_t* slopes_fx) override;
  void quantities(std::int64_t z, std::span<const float*> rows) override;

  /// Computes the parts of the heights of row z.
  void parts_row(std::int64_t z, const LandParts& parts);
  /// A slow field's values at the columns of the last parts_row().
  [[nodiscard]] const float* slow(Slow slow) const { return at_columns_[static_cast<std::size_t>(slow)]; }

 private:
  void begin(std::span<const std::int64_t> xs, bool at_samples, bool sloped);
  void spread_row(std::int64_t z);
  void start_cells();
  void find_cubics(std::int64_t z);
  [[nodiscard]] RegionCells cells(std::int64_t z);
  void spread_climate();
  [[nodiscard]] RegionRow plain_row(std::int64_t z);
  void blend_lines(std::int64_t z);
  void copy_sloped_line(std::int64_t z);
  [[nodiscard]] RegionRow row_of(const std::vector<float*>& at) const;

  const std::shared_ptr<const Regions> regions_;
  const std::shared_ptr<const Places> places_;  // null if quantities are not used
  const float highest_fx_;
  const RegionKernels* kernels_;
  const PlaceKernels* place_kernels_;
  SlowLines lines_;
  RotatedFbm shape_;
  FbmRows border_;
  std::size_t width_ = 0;
  ColumnSpread between_;
  std::vector<AlignedVector<float>> blended_;  // Slow and others, at the samples of a row
  std::vector<AlignedVector<float>> rising_;   // their rise southward
  std::vector<AlignedVector<float>> spread_;   // Slow and others, at the columns
  std::vector<float*> at_columns_;
  // For consecutive columns: whole cells, whose slow rows are not stored.
  bool from_cells_ = false;
  std::size_t first_ = 0;  // columns from the first cell's west to the first requested one; else 0
  std::vector<std::int64_t> whole_cells_;
  SampleRows rows_of_cells_;
  std::array<std::vector<const float*>, 4> sample_lines_;
  std::optional<std::int64_t> lines_from_;  // the line north of the rows for which sample_lines_ is valid
  std::size_t plane_of_cells_ = 0;
  AlignedVector<float> cubics_;  // five planes of rows of cells; see RegionKernels::cubics
  std::vector<float*> first_of_cells_;
  // For coarse levels: the rise of these rows, and the shape's fast octaves.
  bool sloped_ = false;
  bool at_samples_ = false;  // true if the columns of such a level are samples
  float widened_ = 0;        // minimum half width of rivers in terrain units
  std::array<std::vector<AlignedVector<float>>, 2> rises_;
  std::array<std::vector<float*>, 2> rises_at_columns_;
  std::array<std::array<AlignedVector<float>, kShapeOctaves>, 2> octave_rises_;
  AlignedVector<std::int32_t> slopes_;
  std::array<AlignedVector<float>, kShapeOctaves> octaves_;
  AlignedVector<std::int32_t> heights_;
  std::array<AlignedVector<float>, 3> details_;
};

}  // namespace talus::terrain
