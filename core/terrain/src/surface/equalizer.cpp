#include "surface/equalizer.h"

#include <array>
#include <cmath>

namespace talus::terrain {
namespace {

constexpr std::size_t kShares = 8;
constexpr double kBetween = 0.5;  // deviations
// The share of a distribution within 0, 0.5, 1, ... deviations: of the normal distribution, with all of it
// within 3.5, and of one octave, measured at four million positions.
constexpr std::array<double, kShares> kNormal{0, 0.3829, 0.6827, 0.8664, 0.9545, 0.9876, 0.9973, 1};
constexpr std::array<double, kShares> kOneOctave{0, 0.3715, 0.6706, 0.8626, 0.9583, 0.9919, 0.9991, 1};

Spline half_of(double dominance) {
  std::array<Knot, kShares> knots;
  for (std::size_t i = 0; i < kShares; ++i) {
    knots[i] = {kBetween * static_cast<double>(i), kNormal[i] + dominance * (kOneOctave[i] - kNormal[i])};
  }
  return Spline{knots, knots[1].y / kBetween};  // continues the mirrored half
}

}  // namespace

Equalizer::Equalizer(const RotatedNoise& noise)
    : reciprocal_deviation_{static_cast<float>(1 / noise.deviation())}, half_{half_of(noise.dominance())} {}

float Equalizer::operator()(float n) const {
  return std::copysign(half_(std::abs(n * reciprocal_deviation_)), n);
}

}  // namespace talus::terrain
