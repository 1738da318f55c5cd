// Level 0's heights and slopes at the columns of a region.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <talus/terrain/field.h>

#include "kernels/columns.h"
#include "surface/surface_rows.h"

namespace talus::terrain {

/// Keeps its memory from region to region. For one thread at a time.
class Ground {
 public:
  Ground(const Surface& surface, InstructionSet set)
      : rows_{make_surface_rows(surface, set)}, kernels_{column_kernels(set)} {}

  void compute(const Region& region) {
    start(region);
    while (pending()) compute_rows(region.depth);
  }
  /// The same in pieces.
  void start(const Region& region);
  [[nodiscard]] bool pending() const { return next_ < region_.depth; }
  /// REQUIRES pending() and count > 0.
  void compute_rows(int count);

  [[nodiscard]] const Field& height() const { return height_; }
  [[nodiscard]] const Field& slope() const { return slope_; }

 private:
  void compute_base(int first, int last);
  void compute_coarse(int first, int last);

  std::unique_ptr<SurfaceRows> rows_;
  const ColumnKernels& kernels_;
  Region region_;
  int next_ = 0;  // row of the region that is not computed yet
  std::vector<std::int64_t> xs_;
  Field around_;
  std::vector<std::int32_t> slopes_;
  Field height_;
  Field slope_;
};

}  // namespace talus::terrain
