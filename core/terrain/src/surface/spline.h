// Curves defined by knots.
#pragma once

#include <span>
#include <vector>

#include <talus/terrain/regions_spec.h>

namespace talus::terrain {

/// A cubic through its knots that is monotone between adjacent knots and level beyond the outer ones. The
/// slope at an inner knot is the harmonic mean of the adjacent chords' slopes, 0 if these differ in sign
/// (Fritsch and Butland, 1984).
///
/// Evaluated as a sum over segments, each with its full height from its end on, so that vectors need no
/// branches:
/// y(v) = y_0 + sum of t (a + t (b + t c)), t = clamp((v - x) / (width), 0, 1).
class Spline {
 public:
  struct Segment {
    float x = 0;
    float reciprocal = 0;  // 1 / its width
    float a = 0;
    float b = 0;
    float c = 0;
  };

  /// `knots`: at least one, x ascending. The slope at the first is `first_slope`, at the last 0.
  explicit Spline(std::span<const Knot> knots, double first_slope = 0);

  [[nodiscard]] float operator()(float v) const;

  [[nodiscard]] float first_y() const { return first_y_; }
  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

 private:
  float first_y_ = 0;
  std::vector<Segment> segments_;
};

}  // namespace talus::terrain
