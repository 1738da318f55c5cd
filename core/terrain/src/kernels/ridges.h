// Ridged multifractal noise, one row at a time.
#pragma once

#include <cstddef>

#include <talus/vectors/instruction_set.h>

#include "kernels/noise.h"

namespace talus::terrain {

struct RidgeKernels {
  /// Sums the ridges of `count` octaves (ridged_rows.h), each times its weight, less 1/2, over [0, width).
  /// May write kPadding elements past the end.
  void (*sum)(const OctaveRow* octaves, const float* weights, std::size_t count, std::size_t width,
              float feedback, float* out);
};

[[nodiscard]] const RidgeKernels& ridge_kernels(InstructionSet set);

}  // namespace talus::terrain
