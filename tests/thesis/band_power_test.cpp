#include "band_power.h"

#include <cmath>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

using namespace talus::tools;

namespace {

// The sum of waves 8 to 16 samples long, at angles that `angle` draws, on a slope.
template <typename Angle>
std::vector<double> field_of_waves(std::mt19937& random, const Angle& angle) {
  std::vector<double> field(std::size_t{kSpectrumSide} * kSpectrumSide);
  std::uniform_real_distribution<double> unit{0, 1};
  for (int wave = 0; wave < 60; ++wave) {
    const double length = 8 + 8 * unit(random);
    const double phase = 2 * std::numbers::pi * unit(random);
    const double direction = angle(unit(random));
    const double kx = 2 * std::numbers::pi / length * std::cos(direction);
    const double kz = 2 * std::numbers::pi / length * std::sin(direction);
    for (std::size_t i = 0; i < field.size(); ++i) {
      const auto x = static_cast<double>(i % kSpectrumSide);
      const auto z = static_cast<double>(i / kSpectrumSide);
      field[i] += std::sin(kx * x + kz * z + phase);
    }
  }
  for (std::size_t i = 0; i < field.size(); ++i)
    field[i] += 3 * static_cast<double>(i % kSpectrumSide) + 1000;
  return field;
}

}  // namespace

TEST_CASE("Waves of all directions have as much power along the axes as along the diagonals") {
  std::mt19937 random{1};
  std::vector<BandPower> windows;
  for (int i = 0; i < 12; ++i) {
    const auto power =
        band_power(field_of_waves(random, [](double part) { return 2 * std::numbers::pi * part; }));
    REQUIRE(power);
    windows.push_back(*power);
  }
  const BandRatio band = ratio_of(windows);
  CHECK(band.windows == 12);
  CHECK(band.error < 0.2);
  CHECK(std::abs(band.ratio - 1) < 3 * band.error);
}

TEST_CASE("Waves near the axes, or near the diagonals, show in the ratio") {
  std::mt19937 random{2};
  const auto near = [&](double middle) {
    return band_power(field_of_waves(random, [&](double part) {
      const double quarter = std::floor(4 * part) * std::numbers::pi / 2;
      return quarter + middle + (4 * part - std::floor(4 * part) - 0.5) * 0.2;
    }));
  };
  const auto axes = near(0);
  REQUIRE(axes);
  CHECK(axes->axes > 20 * axes->diagonals);
  const auto diagonals = near(std::numbers::pi / 4);
  REQUIRE(diagonals);
  CHECK(diagonals->diagonals > 20 * diagonals->axes);
}

TEST_CASE("A plane has no waves") {
  std::vector<double> plane(std::size_t{kSpectrumSide} * kSpectrumSide);
  CHECK_FALSE(band_power(plane));
  for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = 7 + 2 * static_cast<double>(i / kSpectrumSide);
  CHECK_FALSE(band_power(plane));
}

TEST_CASE("The error of a ratio is zero if all windows agree, and unknown for one window") {
  const std::vector<BandPower> alike(5, BandPower{1.1, 1.0});
  CHECK(ratio_of(alike).ratio == Approx(1.1));
  CHECK(ratio_of(alike).error == Approx(0).margin(1e-12));
  CHECK(ratio_of({alike.data(), 1}).ratio == 0);
  // Residuals of +-0.1 about a ratio of 1: sqrt(2 * 0.01 * 2 / 1) / 2.
  const std::vector<BandPower> two{{1.1, 1.0}, {0.9, 1.0}};
  CHECK(ratio_of(two).error == Approx(0.1));
}
