#include "spec/angles.h"

#include <cmath>
#include <numbers>

namespace talus::terrain {
namespace {

// Taylor's series, up to the term that no longer counts at 45 degrees.
double short_sine(double angle) {
  const double square = angle * angle;
  double sum = 0;
  for (int n = 19; n >= 3; n -= 2) sum = (1 + sum) * -square / static_cast<double>(n * (n - 1));
  return angle + angle * sum;
}

double short_cosine(double angle) {
  const double square = angle * angle;
  double sum = 0;
  for (int n = 20; n >= 2; n -= 2) sum = (1 + sum) * -square / static_cast<double>(n * (n - 1));
  return 1 + sum;
}

/// Returns the sine of `degrees` plus `quarter_turns`.
double sine(double degrees, int quarter_turns) {
  // The remainder, and what is left of it without its quarter turns, are exact.
  const double turn = std::fmod(degrees, 360);
  const double quarters = std::floor(turn / 90 + 0.5);
  const double angle = (turn - 90 * quarters) * std::numbers::pi / 180;
  switch ((static_cast<int>(quarters) + quarter_turns + 4) % 4) {
    case 0:
      return short_sine(angle);
    case 1:
      return short_cosine(angle);
    case 2:
      return -short_sine(angle);
    default:
      return -short_cosine(angle);
  }
}

}  // namespace

double sine_of_degrees(double degrees) {
  return sine(degrees, 0);
}

double cosine_of_degrees(double degrees) {
  return sine(degrees, 1);
}

double tangent_of_degrees(double degrees) {
  return sine_of_degrees(degrees) / cosine_of_degrees(degrees);
}

}  // namespace talus::terrain
