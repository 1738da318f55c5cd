// The surface "regions", row after row.
#pragma once

#include <array>
#include <vector>

#include <talus/vectors/aligned.h>

#include "kernels/regions.h"
#include "noise/rotated_fbm.h"
#include "surface/regions/regions.h"
#include "surface/regions/slow_lines.h"
#include "surface/surface_rows.h"

namespace talus::terrain {

class RegionRows final : public SurfaceRows {
 public:
  RegionRows(const Regions& regions, float highest_fx, InstructionSet set);

  void start(std::span<const std::int64_t> xs) override;
  void row(std::int64_t z, std::int32_t* heights_fx) override;

  /// What a slow field says at the columns of the last row.
  [[nodiscard]] const float* slow(Slow slow) const { return at_columns_[static_cast<std::size_t>(slow)]; }

 private:
  void lay_out(std::span<const std::int64_t> xs);
  void spread(const float* samples, std::size_t slow);

  const Regions regions_;
  const float highest_fx_;
  const RegionKernels* kernels_;
  SlowLines lines_;
  RotatedFbm shape_;
  std::size_t width_ = 0;
  std::vector<std::int64_t> samples_;
  std::size_t columns_a_cell_ = 0;  // 0: they are irregular
  std::size_t skipped_ = 0;         // columns of the first cell that are not asked for
  std::array<float, kSampleStep> fractions_{};
  struct Place {
    std::size_t west = 0;  // the sample
    std::size_t east = 0;
    float fraction = 0;
  };
  std::vector<Place> places_;  // a column, where they are irregular
  std::vector<float> blended_;
  std::array<AlignedVector<float>, kSlowCount> spread_;
  std::array<const float*, kSlowCount> at_columns_{};
  std::array<AlignedVector<float>, kShapeOctaves> octaves_;
  AlignedVector<std::int32_t> heights_;
};

}  // namespace talus::terrain
