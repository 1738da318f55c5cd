// Layers of rock, a row at a time (thesis 3.4).
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/noise.h"

namespace talus::terrain {

/// Columns that are looked at together: ground that is full pays for no more layers.
inline constexpr std::size_t kSegment = 64;

/// How the noise of a layer becomes its thickness: min(mean_fx * max(0, 1 + swing * noise), max_fx).
struct LayerShape {
  float mean_fx = 0;
  float swing = 0;
  float max_fx = 0;
};

struct StrataKernels {
  /// Puts a layer on the segments of a row that are open: top = min(below + thickness, limit), in
  /// subvoxels. `open` has a byte for each segment, 1 or 0; where it is 0 `below` is the limit already, and
  /// `top` becomes it. Those which are full with this layer are open no more; a last one of fewer columns may
  /// stay so as long as the one before it. Whether any is left. The three rows have `width` numbers and no
  /// padding; `top` is none of the others, as columns near the row's end are computed twice.
  bool (*stack)(const OctaveRow* octaves, std::size_t count, const LayerShape& shape, std::size_t width,
                const std::int32_t* limit, const std::int32_t* below, std::uint8_t* open, std::int32_t* top);
  /// The same of a noise that is so much of the way from row `north` to row `south`.
  bool (*stack_between)(const float* north, const float* south, float share, const LayerShape& shape,
                        std::size_t width, const std::int32_t* limit, const std::int32_t* below,
                        std::uint8_t* open, std::int32_t* top);
};

[[nodiscard]] const StrataKernels& strata_kernels(InstructionSet set);

}  // namespace talus::terrain
