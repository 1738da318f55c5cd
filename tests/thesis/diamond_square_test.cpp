#include "diamond_square.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <catch2/catch.hpp>

using namespace talus::tools;

namespace {

std::vector<std::uint16_t> samples_of(const DiamondSquareOptions& options) {
  const auto map = diamond_square(options);
  REQUIRE(map.width == options.side);
  REQUIRE(map.depth == options.side);
  return std::get<std::vector<std::uint16_t>>(map.samples);
}

// The mean step from one column, or one row, to the next.
double mean_step(const std::vector<std::uint16_t>& samples, int side, int from, bool along_x) {
  double sum = 0;
  const auto at = [&](int across, int along) {
    const int wrapped = along % side;
    const int index = along_x ? across * side + wrapped : wrapped * side + across;
    return static_cast<int>(samples[static_cast<std::size_t>(index)]);
  };
  for (int i = 0; i < side; ++i) sum += std::abs(at(i, from + 1) - at(i, from));
  return sum / side;
}

}  // namespace

TEST_CASE("A diamond-square map has all of its range, at every size and roughness") {
  for (const int side : {8, 64, 256}) {
    for (const double roughness : {0.0, 0.5, 1.0}) {
      const auto samples = samples_of({3, side, roughness});
      CHECK(*std::min_element(samples.begin(), samples.end()) == 0);
      CHECK(*std::max_element(samples.begin(), samples.end()) == 65535);
    }
  }
}

TEST_CASE("A diamond-square map is its seed's and no other's") {
  CHECK(samples_of({7, 64, 0.5}) == samples_of({7, 64, 0.5}));
  CHECK(samples_of({7, 64, 0.5}) != samples_of({8, 64, 0.5}));
}

TEST_CASE("The step over the edge of a diamond-square map is like every other") {
  constexpr int kSide = 256;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto samples = samples_of({seed, kSide, 0.5});
    for (const bool along_x : {true, false}) {
      double most = 0;
      for (int i = 0; i + 1 < kSide; ++i) most = std::max(most, mean_step(samples, kSide, i, along_x));
      CHECK(mean_step(samples, kSide, kSide - 1, along_x) <= most);
    }
  }
}

TEST_CASE("The rougher a diamond-square map, the longer its steps") {
  const auto step = [](double roughness) {
    const auto samples = samples_of({1, 128, roughness});
    double sum = 0;
    for (int i = 0; i < 128; ++i) sum += mean_step(samples, 128, i, true);
    return sum;
  };
  CHECK(step(0.3) < step(0.5));
  CHECK(2 * step(0.5) < step(0.8));
}

TEST_CASE("The first samples of a diamond-square map are what they were") {
  const auto samples = samples_of({2019, 512, 0.5});
  const std::vector<std::uint16_t> first(samples.begin(), samples.begin() + 4);
  CHECK(first == std::vector<std::uint16_t>{36023, 36792, 37697, 38260});
}
