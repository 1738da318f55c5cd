// Ridged multifractal noise, a row at a time.
#pragma once

#include <cstddef>

#include <talus/vectors/instruction_set.h>

#include "kernels/noise.h"

namespace talus::terrain {

struct RidgeKernels {
  /// Sums the ridges of `count` octaves (ridged_rows.h), each times its weight, less 1/2, over [0, width);
  /// may write up to kPadding further.
  void (*sum)(const OctaveRow* octaves, const float* weights, std::size_t count, std::size_t width,
              float feedback, float* out);
};

[[nodiscard]] const RidgeKernels& ridge_kernels(InstructionSet set);

}  // namespace talus::terrain
