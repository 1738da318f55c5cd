#include "surface/spline.h"

#include <algorithm>

namespace talus::terrain {
namespace {

double chord(const Knot& from, const Knot& to) {
  return (to.y - from.y) / (to.x - from.x);
}

double slope_between(double before, double after) {
  return before * after <= 0 ? 0 : 2 * before * after / (before + after);
}

}  // namespace

Spline::Spline(std::span<const Knot> knots, double first_slope) {
  first_y_ = static_cast<float>(knots.front().y);
  double slope = first_slope;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double width = knots[i + 1].x - knots[i].x;
    const double height = knots[i + 1].y - knots[i].y;
    const bool last = i + 2 == knots.size();
    const double next =
        last ? 0 : slope_between(chord(knots[i], knots[i + 1]), chord(knots[i + 1], knots[i + 2]));
    const double at_start = slope * width;
    const double at_end = next * width;
    segments_.push_back({static_cast<float>(knots[i].x), static_cast<float>(1 / width),
                         static_cast<float>(at_start), static_cast<float>(3 * height - 2 * at_start - at_end),
                         static_cast<float>(at_start + at_end - 2 * height)});
    slope = next;
  }
}

float Spline::operator()(float v) const {
  float y = first_y_;
  for (const Segment& s : segments_) {
    const float t = std::clamp((v - s.x) * s.reciprocal, 0.0F, 1.0F);
    y += t * (s.a + t * (s.b + t * s.c));
  }
  return y;
}

}  // namespace talus::terrain
