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

  void compute(const Region& region);

  [[nodiscard]] const Field& height() const { return height_; }
  [[nodiscard]] const Field& slope() const { return slope_; }

 private:
  void compute_base(const Region& region);
  void compute_coarse(const Region& region);

  std::unique_ptr<SurfaceRows> rows_;
  const ColumnKernels& kernels_;
  std::vector<std::int64_t> xs_;
  Field around_;
  std::vector<std::int32_t> slopes_;
  Field height_;
  Field slope_;
};

}  // namespace talus::terrain
