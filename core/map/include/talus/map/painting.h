// Drawing in pieces, for a caller that may pause or stop between two pieces.
#pragma once

namespace talus::map {

class Painting {
 public:
  virtual ~Painting() = default;
  /// Does some milliseconds of work; false when nothing is left. The pixels do not depend on the pieces.
  virtual bool step() = 0;
};

/// Columns around a painted area that affect its light.
inline constexpr int kReliefRing = 24;
/// Rows of pixels painted per step.
inline constexpr int kRowsAStep = 16;

/// The factor by which heights are scaled for shading if a pixel covers `columns_a_pixel` columns. Without it
/// mountains seen from afar would look flat.
[[nodiscard]] float exaggeration(float columns_a_pixel);

}  // namespace talus::map
