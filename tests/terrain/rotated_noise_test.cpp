// Value + gradient noise on rotated lattices: kernels_test.cpp compares its rows with its points.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "noise/rotated_fbm.h"
#include "noise/rotated_lattice.h"

namespace talus::terrain {
namespace {

constexpr std::int64_t kFar = std::int64_t{1} << 36;
constexpr double kCell = 4294967296.0;

struct Moments {
  double sum = 0;
  double squares = 0;
  int count = 0;

  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  [[nodiscard]] double mean() const { return sum / count; }
  [[nodiscard]] double variance() const { return squares / count - mean() * mean(); }
};

TEST_CASE("A rotated lattice has cells of its wavelength, and no octave lies near an axis") {
  CHECK(rc::check([] {
    const int k = *rc::gen::inRange(0, 8);
    const std::int64_t period = *rc::gen::inRange<std::int64_t>(std::int64_t{2} << k, 1 << 20);
    const int turn = *rc::gen::inRange(0, 100);
    const RotatedLattice lattice = rotated_lattice(*rc::gen::arbitrary<std::uint64_t>(), period, k, turn);
    const double east = static_cast<double>(lattice.du) / kCell;
    const double south = static_cast<double>(lattice.dv) / kCell;
    const double wavelength = static_cast<double>(period) / static_cast<double>(1 << k);
    RC_ASSERT(std::abs(std::hypot(east, south) * wavelength - 1) < wavelength * std::exp2(-32));
    const double degrees = std::atan2(south, east) * 180 / M_PI;
    RC_ASSERT(std::abs(degrees - (16 + 9 * ((turn + 5 * k) % 8))) < wavelength * 1e-7);
    RC_ASSERT(std::min(degrees, 90 - degrees) > 10.9);
  }));
}

TEST_CASE("Rotated noise varies as much at its lattice's points as between them, and keeps its bound") {
  const RotatedLattice lattice = rotated_lattice(1, 64, 0, 0);
  std::mt19937_64 random{2};
  Moments corners;
  Moments middles;
  Moments anywhere;
  double most = 0;
  for (int i = 0; i < 200'000; ++i) {
    const std::uint64_t u = random();
    const std::uint64_t v = random();
    constexpr std::uint64_t kWhole = ~std::uint64_t{0xFFFFFFFF};
    corners.add(rotated_sample(lattice, u & kWhole, v & kWhole).value);
    middles.add(rotated_sample(lattice, (u & kWhole) + 0x80000000U, (v & kWhole) + 0x80000000U).value);
    anywhere.add(rotated_sample(lattice, u, v).value);
    most = std::max(most, std::abs(static_cast<double>(rotated_sample(lattice, u, v).value)));
  }
  CHECK(std::abs(corners.mean()) < 0.002);
  CHECK(std::abs(middles.mean()) < 0.002);
  CHECK(corners.variance() == Approx(1.0 / 18).epsilon(0.02));
  CHECK(middles.variance() == Approx(1.0 / 18).epsilon(0.02));
  CHECK(std::sqrt(anywhere.variance()) == Approx(kRotatedDeviation).epsilon(0.01));
  CHECK(most < 1.55);
}

TEST_CASE("Rotated fBm deviates as it says, whatever the gain") {
  for (const double gain : {0.3, 0.5, 0.9}) {
    const RotatedNoise noise{7, 256, 5, gain, 3};
    std::mt19937_64 random{3};
    std::uniform_int_distribution<std::int64_t> column{-kFar, kFar};
    Moments moments;
    for (int i = 0; i < 100'000; ++i) {
      const std::int64_t x = column(random);
      const std::int64_t z = column(random);
      moments.add(rotated_fbm(noise, x, z));
    }
    CAPTURE(gain);
    CHECK(std::sqrt(moments.variance()) == Approx(noise.deviation()).epsilon(0.01));
  }
}

// Steps of equal length: a fivefold one lies along an axis, or 3 and 4 along both.
TEST_CASE("Rotated fBm is as rough along the axes as across them") {
  struct Step {
    std::int64_t x;
    std::int64_t z;
  };
  for (const std::int64_t scale : {1, 8}) {
    std::array<double, 2> rough{};
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const RotatedNoise noise{seed, 256, 6, 0.5, static_cast<int>(seed)};
      std::mt19937_64 random{seed};
      std::uniform_int_distribution<std::int64_t> column{-1'000'000, 1'000'000};
      const std::array<std::array<Step, 4>, 2> steps{
          {{{{5, 0}, {0, 5}, {-5, 0}, {0, -5}}}, {{{3, 4}, {4, 3}, {3, -4}, {4, -3}}}}};
      for (int i = 0; i < 4000; ++i) {
        const std::int64_t x = column(random);
        const std::int64_t z = column(random);
        const double here = rotated_fbm(noise, x, z);
        for (std::size_t kind = 0; kind < 2; ++kind) {
          for (const Step& step : steps[kind]) {
            const double there = rotated_fbm(noise, x + scale * step.x, z + scale * step.z);
            rough[kind] += (there - here) * (there - here);
          }
        }
      }
    }
    CAPTURE(scale);
    CHECK(rough[0] / rough[1] == Approx(1).epsilon(0.03));
  }
}

TEST_CASE("Rotated noise is as smooth at the world's ends as at its origin") {
  const RotatedNoise noise{7, 256, 4, 0.5, 0};
  for (const std::int64_t x0 : {std::int64_t{0}, kFar - 512, -kFar}) {
    float steepest = 0;
    for (int i = 0; i < 512; ++i) {
      const float step = rotated_fbm(noise, x0 + i + 1, x0) - rotated_fbm(noise, x0 + i, x0);
      steepest = std::max(steepest, std::abs(step));
    }
    CHECK(steepest < 0.1F);
    CHECK(steepest > 0.005F);
  }
}

TEST_CASE("Rotated noise rises as its neighbours say") {
  CHECK(rc::check([] {
    const RotatedNoise noise{*rc::gen::arbitrary<std::uint64_t>(), 2048, *rc::gen::inRange(1, 4), 0.5,
                             *rc::gen::inRange(0, 8)};
    const std::int64_t x = *rc::gen::inRange<std::int64_t>(-kFar, kFar);
    const std::int64_t z = *rc::gen::inRange<std::int64_t>(-kFar, kFar);
    const SlopedNoise here = sloped_rotated_fbm(noise, x, z);
    const float east = (rotated_fbm(noise, x + 4, z) - rotated_fbm(noise, x - 4, z)) / 8;
    const float south = (rotated_fbm(noise, x, z + 4) - rotated_fbm(noise, x, z - 4)) / 8;
    RC_ASSERT(std::abs(here.east - east) < 2e-5F);
    RC_ASSERT(std::abs(here.south - south) < 2e-5F);
  }));
}

TEST_CASE("A displacement of whole columns is as good as being there") {
  CHECK(rc::check([] {
    const RotatedNoise noise{*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange<std::int64_t>(64, 4096),
                             3, 0.5, *rc::gen::inRange(0, 8)};
    const std::int64_t x = *rc::gen::inRange<std::int64_t>(-kFar, kFar);
    const std::int64_t z = *rc::gen::inRange<std::int64_t>(-kFar, kFar);
    const std::int32_t east = *rc::gen::inRange(-16384, 16385);
    const std::int32_t south = *rc::gen::inRange(-16384, 16385);
    const float there = rotated_fbm(noise, x + east, z + south);
    RC_ASSERT(rotated_fbm(noise, x, z, 256 * east, 256 * south) == there);
  }));
}

// A world's voxels stand on these bits.
TEST_CASE("Rotated noise has not changed") {
  const RotatedNoise noise{2019, 1400, 8, 0.47, 0};
  CHECK(rotated_fbm(noise, 0, 0) == 0x1.67c004p-2F);
  CHECK(rotated_fbm(noise, 123, -456) == 0x1.f33874p-2F);
  CHECK(rotated_fbm(noise, kFar, -kFar, 77, -1234567) == -0x1.1e4f94p-9F);
}

}  // namespace
}  // namespace talus::terrain
