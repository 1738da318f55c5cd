// Makes a noise uniform, so that an author reads shares of land off a field's values: where a field is below
// -0.2 lie 40 % of the world.
#pragma once

#include "noise/rotated_fbm.h"
#include "surface/spline.h"

namespace talus::terrain {

/// Of one noise. Its values become uniform in -1 to 1, to 0.005.
class Equalizer {
 public:
  explicit Equalizer(const RotatedNoise& noise);

  [[nodiscard]] float operator()(float n) const;

  /// (*this)(n) is half()(|n * reciprocal_deviation()|) with the sign of n.
  [[nodiscard]] float reciprocal_deviation() const { return reciprocal_deviation_; }
  [[nodiscard]] const Spline& half() const { return half_; }

 private:
  float reciprocal_deviation_;
  Spline half_;
};

}  // namespace talus::terrain
