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

  /// Whether no noise makes it less than 0 or cuts it at max_fx. Noise lies between -1 and 1: twice that is
  /// more than enough for what is rounded.
  [[nodiscard]] bool is_bounded() const { return swing <= 0.5F && mean_fx * (1 + 2 * swing) <= max_fx; }
  /// More than it comes to anywhere, where it is bounded; a noise's bound is a hundredth more than it needs.
  [[nodiscard]] std::int32_t most_fx() const {
    return static_cast<std::int32_t>(mean_fx * (1 + 1.01F * swing)) + 2;
  }
};

/// A layer of many rows: its noise at lines of columns, what is added to it up to the next line, and its
/// plane.
struct LinedLayer {
  LayerShape shape;
  const float* noise = nullptr;
  const float* rise = nullptr;
  std::int32_t* top = nullptr;
};

/// A row of it: which line it lies at or past, and where its plane has it, both counted in numbers.
struct RowBetween {
  std::size_t line = 0;
  float share = 0;  // of the way to the next line
  std::size_t top = 0;
};

struct StrataKernels {
  /// LinedLayer's rise, of its noise at `count` lines of `row` numbers each: 0 at the last, past which no row
  /// lies. REQUIRES count > 0.
  void (*find_rises)(const float* noise, std::size_t row, std::size_t count, float* rise);
  /// Puts a layer on the segments of a row that are open: top = min(below + thickness, limit), in
  /// subvoxels. `open` has a byte for each segment, 1 or 0; where it is 0 `below` is the limit already, and
  /// `top` becomes it. Those which are full with this layer are open no more; a last one of fewer columns may
  /// stay so as long as the one before it. Whether any is left. The three rows have `width` numbers and no
  /// padding; `top` is none of the others, as columns near the row's end are computed twice.
  bool (*stack)(const OctaveRow* octaves, std::size_t count, const LayerShape& shape, std::size_t width,
                const std::int32_t* limit, const std::int32_t* below, std::uint8_t* open, std::int32_t* top);
  /// The same of `count` layers one upon the other, the first on `below`; more than one of them may be of one
  /// plane. How many of them it takes until no segment is open, or count + 1.
  std::size_t (*stack_between)(const LinedLayer* layers, std::size_t count, const RowBetween& row,
                               std::size_t width, const std::int32_t* limit, const std::int32_t* below,
                               std::uint8_t* open);
  /// The same of bounded layers which surely end under the limit, so that nothing is cut. From the last of
  /// them, or from `below` where there is none, to the limit in the column where that is least.
  /// REQUIRES width > 0.
  std::int32_t (*stack_inside)(const LinedLayer* layers, std::size_t count, const RowBetween& row,
                               std::size_t width, const std::int32_t* limit, const std::int32_t* below);
};

[[nodiscard]] const StrataKernels& strata_kernels(InstructionSet set);

}  // namespace talus::terrain
