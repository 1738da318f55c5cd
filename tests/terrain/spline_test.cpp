#include "surface/spline.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "noise/rotated_fbm.h"
#include "surface/equalizer.h"

namespace talus::terrain {
namespace {

std::vector<Knot> any_knots() {
  std::vector<Knot> knots;
  double x = *rc::gen::inRange(-100, 100) * 0.01;
  const int count = *rc::gen::inRange(1, 12);
  for (int i = 0; i < count; ++i) {
    knots.push_back({x, *rc::gen::inRange(-300, 300) * 0.1});
    x += *rc::gen::inRange(1, 100) * 0.01;
  }
  return knots;
}

TEST_CASE("A spline goes through its knots and is level beyond them") {
  CHECK(rc::check([] {
    const auto knots = any_knots();
    const Spline spline{knots};
    for (const Knot& knot : knots) RC_ASSERT(std::abs(spline(static_cast<float>(knot.x)) - knot.y) < 2e-3);
    RC_ASSERT(spline(static_cast<float>(knots.front().x - 5)) == spline.first_y());
    RC_ASSERT(std::abs(spline(static_cast<float>(knots.back().x + 5)) - knots.back().y) < 2e-4);
  }));
}

TEST_CASE("A spline is monotone between its knots, and so within their heights") {
  CHECK(rc::check([] {
    const auto knots = any_knots();
    const Spline spline{knots};
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const bool rises = knots[i + 1].y >= knots[i].y;
      float before = spline(static_cast<float>(knots[i].x));
      for (int step = 1; step <= 50; ++step) {
        const double x = knots[i].x + (knots[i + 1].x - knots[i].x) * step / 50;
        const float here = spline(static_cast<float>(x));
        RC_ASSERT((rises ? here - before : before - here) > -1e-3F);
        RC_ASSERT(here >= std::min(knots[i].y, knots[i + 1].y) - 1e-3);
        RC_ASSERT(here <= std::max(knots[i].y, knots[i + 1].y) + 1e-3);
        before = here;
      }
    }
  }));
}

TEST_CASE("Equalized, a field takes every value as often, whatever its octaves") {
  std::mt19937_64 random{12};
  std::uniform_int_distribution<std::int64_t> column{-(std::int64_t{1} << 36), std::int64_t{1} << 36};
  for (const auto& [octaves, gain] : {std::pair{1, 0.5}, {3, 0.3}, {5, 0.5}, {8, 0.9}}) {
    const RotatedNoise noise{11, 4096, octaves, gain, 2};
    const Equalizer equalized{noise};
    constexpr int kPlaces = 400'000;
    constexpr int kSteps = 20;
    std::array<int, kSteps> below{};
    float most = 0;
    for (int i = 0; i < kPlaces; ++i) {
      const std::int64_t x = column(random);
      const std::int64_t z = column(random);
      const float value = equalized(rotated_fbm(noise, x, z));
      most = std::max(most, std::abs(value));
      for (int step = static_cast<int>((value + 1) * kSteps / 2) + 1; step < kSteps; ++step) {
        ++below[static_cast<std::size_t>(step)];
      }
    }
    CAPTURE(octaves, gain);
    CHECK(most <= 1.00001F);
    for (int step = 1; step < kSteps; ++step) {
      const double share = static_cast<double>(below[static_cast<std::size_t>(step)]) / kPlaces;
      CHECK(std::abs(share - static_cast<double>(step) / kSteps) < 0.005);
    }
    CHECK(equalized(9) == Approx(1).epsilon(1e-5));
    CHECK(equalized(-0.3F) == -equalized(0.3F));
  }
}

}  // namespace
}  // namespace talus::terrain
