#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <vector>

#include <talus/terrain/fbm.h>

#include "reference.h"

namespace talus::terrain {
namespace {

constexpr std::int64_t kFar = std::int64_t{1} << 36;

rc::Gen<std::int64_t> any_column() {
  return rc::gen::oneOf(
      rc::gen::inRange<std::int64_t>(-kFar, kFar), rc::gen::inRange<std::int64_t>(-300, 300),
      rc::gen::inRange<std::int64_t>(kFar - 100, kFar), rc::gen::inRange<std::int64_t>(-kFar, 100 - kFar));
}

Fbm any_noise() {
  Fbm noise;
  noise.seed = *rc::gen::arbitrary<std::uint64_t>();
  noise.period =
      *rc::gen::oneOf(rc::gen::inRange<std::int64_t>(2, 2000), rc::gen::inRange<std::int64_t>(2, 1 << 24));
  noise.octaves = *rc::gen::inRange(1, 9);
  return noise;
}

float at(const Fbm& noise, std::int64_t x, std::int64_t z) {
  float value = 0;
  sample_fbm(noise, {&x, 1}, {&z, 1}, {&value, 1});
  return value;
}

TEST_CASE("fBm is textbook Perlin noise within float rounding") {
  CHECK(rc::check([] {
    const Fbm noise = any_noise();
    const std::int64_t x = *any_column();
    const std::int64_t z = *any_column();
    RC_ASSERT(std::abs(at(noise, x, z) - test::reference::fbm(noise, x, z)) < 2e-6);
  }));
}

TEST_CASE("A grid of fBm has the bits of its points, whatever grid they are taken from") {
  CHECK(rc::check([] {
    const Fbm noise = any_noise();
    const auto line = [](std::int64_t first, std::int64_t step, int count) {
      std::vector<std::int64_t> columns;
      for (int i = 0; i < count; ++i) columns.push_back(first + i * step);
      return columns;
    };
    const std::vector<std::int64_t> xs =
        line(*any_column(), *rc::gen::inRange(1, 65), *rc::gen::inRange(1, 40));
    const std::vector<std::int64_t> zs =
        line(*any_column(), *rc::gen::inRange(1, 65), *rc::gen::inRange(1, 10));
    std::vector<float> grid(xs.size() * zs.size());
    sample_fbm(noise, xs, zs, grid);
    for (std::size_t j = 0; j < zs.size(); ++j) {
      for (std::size_t i = 0; i < xs.size(); ++i)
        RC_ASSERT(grid[j * xs.size() + i] == at(noise, xs[i], zs[j]));
    }
  }));
}

TEST_CASE("fBm stays within -1 and 1 and is as smooth far out as at the origin") {
  const Fbm noise{7, 256, 4};
  for (const std::int64_t x0 : {std::int64_t{0}, kFar - 512, -kFar}) {
    float steepest = 0;
    std::vector<std::int64_t> xs;
    for (int i = 0; i < 512; ++i) xs.push_back(x0 + i);
    std::vector<float> row(xs.size());
    sample_fbm(noise, xs, std::array{x0}, row);
    for (std::size_t i = 0; i < row.size(); ++i) {
      CHECK(std::abs(row[i]) <= 1.0F);
      if (i > 0) steepest = std::max(steepest, std::abs(row[i] - row[i - 1]));
    }
    CHECK(steepest < 0.05F);
    CHECK(steepest > 0.001F);
  }
}

TEST_CASE("Octaves too fine for the lattice are left out and the rest keeps its weight") {
  const Fbm coarse{3, 9, 2};  // octaves of 9 and 4.5 columns
  const Fbm fine{3, 9, 8};    // the third has cells of 2.25; the fourth would have 1.1 and is left out
  CHECK(fine.has_octave(2));
  CHECK_FALSE(fine.has_octave(3));
  CHECK(std::abs(at(fine, 5, 5) - test::reference::fbm(fine, 5, 5)) < 1e-6);
  CHECK(std::abs(at(coarse, 5, 5) - test::reference::fbm(coarse, 5, 5)) < 1e-6);
}

}  // namespace
}  // namespace talus::terrain
