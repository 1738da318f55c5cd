#include <talus/terrain/slope.h>

#include "kernels/columns.h"

namespace talus::terrain {

Field slope_inside(const Field& heights) {
  const ColumnKernels& kernels = column_kernels(instruction_set());
  Field slope{heights.width - 2, heights.depth - 2};
  for (int z = 0; z < slope.depth; ++z) {
    kernels.slope(heights.row(z).data(), heights.row(z + 1).data(), heights.row(z + 2).data(),
                  static_cast<std::size_t>(slope.width), slope.row(z).data());
  }
  return slope;
}

}  // namespace talus::terrain
