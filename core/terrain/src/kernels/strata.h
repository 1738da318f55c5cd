// Layers of rock, one row at a time (thesis 3.4).
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/noise.h"

namespace talus::terrain {

/// Columns processed together; segments that are full skip further layers.
inline constexpr std::size_t kSegment = 64;

/// A layer's thickness by noise: min(mean_fx * max(0, 1 + swing * noise), max_fx).
struct LayerShape {
  float mean_fx = 0;
  float swing = 0;
  float max_fx = 0;

  /// Returns true if no noise makes it negative or cuts it at max_fx. Noise lies between -1 and 1; a factor
  /// of two is more than enough for rounding.
  [[nodiscard]] bool is_bounded() const { return swing <= 0.5F && mean_fx * (1 + 2 * swing) <= max_fx; }
  /// Exceeds the thickness everywhere if is_bounded(); the bound of noise has a margin of a hundredth.
  [[nodiscard]] std::int32_t bound_fx() const {
    return static_cast<std::int32_t>(mean_fx * (1 + 1.01F * swing)) + 2;
  }
};

/// A layer of many rows: its noise at lines of columns, the difference to the next line, and its plane.
struct LinedLayer {
  LayerShape shape;
  const float* noise = nullptr;
  const float* rise = nullptr;
  std::int32_t* top = nullptr;
};

/// A row of it: the line at or before it, and its place in the layer's plane, both as element offsets.
struct RowBetween {
  std::size_t line = 0;
  float share = 0;  // share of the way to the next line
  std::size_t top = 0;
};

struct StrataKernels {
  /// Computes LinedLayer::rise from its noise at `count` lines of `row` elements each: 0 at the last line,
  /// past which no row lies. REQUIRES count > 0.
  void (*find_rises)(const float* noise, std::size_t row, std::size_t count, float* rise);
  /// Puts a layer on the open segments of a row: top = min(below + thickness, limit), in subvoxels. `open`
  /// has a byte per segment, 1 or 0; if it is 0, `below` already equals the limit, and so does `top`. Closes
  /// the segments that this layer fills; a shorter last segment may stay open as long as the one before it.
  /// Returns true if a segment is still open. The three rows have `width` elements and no padding; `top` must
  /// not alias the others, as columns near the row's end are computed twice.
  bool (*stack)(const OctaveRow* octaves, std::size_t count, const LayerShape& shape, std::size_t width,
                const std::int32_t* limit, const std::int32_t* below, std::uint8_t* open, std::int32_t* top);
  /// stack() for `count` layers on top of each other, the first on `below`; several of them may share a
  /// plane. Returns the number of layers after which no segment is open, or count + 1.
  std::size_t (*stack_between)(const LinedLayer* layers, std::size_t count, const RowBetween& row,
                               std::size_t width, const std::int32_t* limit, const std::int32_t* below,
                               std::uint8_t* open);
  /// stack() for bounded layers that surely end under the limit, so nothing is cut. Returns the minimum
  /// distance from the last layer, or from `below` if count is 0, to the limit. REQUIRES width > 0.
  std::int32_t (*stack_inside)(const LinedLayer* layers, std::size_t count, const RowBetween& row,
                               std::size_t width, const std::int32_t* limit, const std::int32_t* below);
};

[[nodiscard]] const StrataKernels& strata_kernels(InstructionSet set);

}  // namespace talus::terrain
