// Drawing in pieces, for a caller who holds a clock and may stop between two of them.
#pragma once

namespace talus::map {

class Painting {
 public:
  virtual ~Painting() = default;
  /// Some milliseconds of work; false when nothing is left. The pixels do not depend on the pieces.
  virtual bool step() = 0;
};

/// Columns around what is painted that decide its light.
inline constexpr int kReliefRing = 24;
/// Rows of pixels that a step paints.
inline constexpr int kRowsAStep = 16;

/// Mountains seen from afar are flat; a map of a continent lifts them: the factor for heights as light falls
/// on them, where a pixel stands for a column of so many.
[[nodiscard]] float exaggeration(float columns_a_pixel);

}  // namespace talus::map
