// Makes a noise uniform, so that authors read shares of land off a field's values: 40 % lie below -0.2.
#pragma once

#include "noise/rotated_fbm.h"
#include "surface/spline.h"

namespace talus::terrain {

/// Maps the values of one noise to values uniform in -1 to 1, with an error of at most 0.005.
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
