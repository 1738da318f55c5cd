// Height maps as surfaces: the cubic beside a literal one, what lies outside, and what is refused.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <talus/terrain/surface.h>
#include <talus/terrain/world.h>

#include "made_height_map.h"
#include "reference.h"
#include "surface/cubic.h"
#include "surface/scaled_heights.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

constexpr std::int64_t kFar = std::int64_t{1} << 36;

Surface any_map(Outside outside) {
  Surface surface;
  surface.kind = SurfaceKind::height_map;
  surface.highest_fx = static_cast<float>(*rc::gen::element(1 << 8, 1 << 16, 1 << 23));
  auto heights = std::make_shared<Field>(*rc::gen::inRange(2, 12), *rc::gen::inRange(2, 12));
  for (auto& value : heights->values) value = *rc::gen::inRange(0, static_cast<int>(surface.highest_fx) + 1);
  surface.map.heights_fx = heights;
  surface.map.outside = outside;
  const auto place = rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-9999999, 9999999),
                                    rc::gen::element<std::int64_t>(kFar << 16, -(kFar << 16)));
  surface.map.x_q16 = *place;
  surface.map.z_q16 = *place;
  const auto spacing = rc::gen::oneOf(rc::gen::inRange<std::int64_t>(65536, 65536 * 20),
                                      rc::gen::element<std::int64_t>(65536, 65536 * 4096));
  surface.map.spacing_x_q16 = *spacing;
  surface.map.spacing_z_q16 = *spacing;
  return surface;
}

std::int32_t height_at(const Surface& surface, std::int64_t x, std::int64_t z) {
  std::int32_t height = 0;
  sample_surface(surface, {&x, 1}, {&z, 1}, {&height, 1});
  return height;
}

TEST_CASE("The weights of a cubic sum to one, and reach one sample at a sample") {
  CHECK(cubic_weights(0) == std::array<std::int64_t, 4>{0, kCubicOne, 0, 0});
  for (std::int64_t t = 0; t < std::int64_t{1} << kPlaceBits; t += 37) {
    const auto w = cubic_weights(t);
    CHECK(w[0] + w[1] + w[2] + w[3] == kCubicOne);
    CHECK(std::abs(w[0]) + std::abs(w[1]) + std::abs(w[2]) + std::abs(w[3]) <= kCubicOne * 5 / 4 + 4);
  }
}

TEST_CASE("A height map is the textbook's cubic between its samples, cut off at its range") {
  CHECK(rc::check([] {
    const Surface surface = any_map(*rc::gen::element(Outside::mirror, Outside::sea, Outside::repeat));
    const PlacedMap& map = surface.map;
    // Within and around the map, to some of its own sizes away.
    const auto near = [](std::int64_t origin_q16, std::int64_t spacing_q16, int samples) {
      const std::int64_t size = samples * spacing_q16 >> 16;
      return (origin_q16 >> 16) + *rc::gen::inRange<std::int64_t>(-3 * size - 5, 4 * size + 5);
    };
    const std::int64_t x = near(map.x_q16, map.spacing_x_q16, map.heights_fx->width);
    const std::int64_t z = near(map.z_q16, map.spacing_z_q16, map.heights_fx->depth);
    const double exact =
        std::clamp(test::reference::height_map(map, x, z), 0.0, static_cast<double>(surface.highest_fx));
    RC_ASSERT(std::abs(height_at(surface, x, z) - exact) <= 0.51 + surface.highest_fx / (1 << 16));
  }));
}

TEST_CASE("At its samples a height map has their heights, and a level map is level everywhere") {
  Surface surface;
  surface.kind = SurfaceKind::height_map;
  surface.highest_fx = 1 << 23;
  auto heights = std::make_shared<Field>(3, 4);
  std::iota(heights->values.begin(), heights->values.end(), 1000);
  surface.map = {heights, 5 << 16, -7 * 65536, 9 << 16, 11 << 16, Outside::mirror, 0, SurfaceKind::perlin};
  for (int z = 0; z < 4; ++z) {
    for (int x = 0; x < 3; ++x) CHECK(height_at(surface, 5 + 9 * x, -7 + 11 * z) == heights->at(x, z));
  }
  heights->values.assign(12, 8388607);
  for (std::int64_t x = -100; x < 100; ++x) CHECK(height_at(surface, x, 3 * x) == 8388607);
}

TEST_CASE("Beyond a drowned map all is at the floor, and beyond a blended one the surface around it") {
  const World drowned = test::small_world(3, "sea");
  const World blended = test::small_world(3, "blend");
  WorldSpec around = blended.spec();
  around.surface.kind = SurfaceKind::perlin;
  around.surface.height_map.reset();
  // 29 x 23 samples of 0.21 terrain units of 40 voxels, from (-52, 28); a margin of 60 voxels.
  CHECK(height_at(surface_of(drowned.spec()), -80, 100) == 0);
  CHECK(height_at(surface_of(drowned.spec()), 0, 100) > 0);
  WorldSpec mirrored = blended.spec();
  mirrored.surface.height_map->outside = Outside::mirror;
  const auto same = [&](const WorldSpec& other, std::int64_t x, std::int64_t z) {
    return height_at(surface_of(blended.spec()), x, z) == height_at(surface_of(other), x, z);
  };
  CHECK(same(around, -53, 100));
  CHECK(same(around, 0, 27));
  CHECK(same(around, 184, 213));
  CHECK_FALSE(same(around, -20, 100));
  CHECK_FALSE(same(mirrored, -20, 100));
  CHECK(same(mirrored, 8, 88));
  CHECK(same(mirrored, 100, 130));
}

TEST_CASE("A repeated map is the same one period on, at both ends of the world too") {
  CHECK(rc::check([] {
    Surface surface = any_map(Outside::repeat);
    PlacedMap& map = surface.map;
    map.spacing_x_q16 = map.spacing_x_q16 >> 16 << 16;  // a period of whole columns
    map.spacing_z_q16 = map.spacing_z_q16 >> 16 << 16;
    const std::int64_t period_x = map.heights_fx->width * (map.spacing_x_q16 >> 16);
    const std::int64_t period_z = map.heights_fx->depth * (map.spacing_z_q16 >> 16);
    const std::int64_t x = *rc::gen::inRange<std::int64_t>(-kFar / 2, kFar / 2);
    const std::int64_t z = *rc::gen::inRange<std::int64_t>(-kFar / 2, kFar / 2);
    const std::int64_t turns = *rc::gen::inRange<std::int64_t>(-3, 4);
    RC_ASSERT(height_at(surface, x, z) == height_at(surface, x + turns * period_x, z - turns * period_z));
  }));
}

TEST_CASE("Across the seam of a repeated map lie samples that are neighbours") {
  Surface surface;
  surface.kind = SurfaceKind::height_map;
  surface.highest_fx = 1000;
  auto heights = std::make_shared<Field>(4, 2);
  heights->values = {0, 100, 200, 100, 0, 100, 200, 100};
  surface.map = {heights, 0, 0, 8 << 16, 8 << 16, Outside::repeat, 0, SurfaceKind::perlin};
  // An even zigzag: as it rises from its first sample, so it falls past its last.
  for (std::int64_t x = 0; x < 8; ++x) CHECK(height_at(surface, 24 + x, 3) == height_at(surface, 8 - x, 3));
  CHECK(height_at(surface, 28, 3) == 38);  // (9 * 100 - 200 - 100) / 16, by the samples 200, 100, 0 and 100
}

TEST_CASE("A blend has no step anywhere in its margin") {
  const Surface surface = surface_of(test::small_world(4, "blend").spec());
  std::int32_t before = height_at(surface, -300, 60);
  for (std::int64_t x = -299; x < 400; ++x) {
    const std::int32_t here = height_at(surface, x, 60);
    CHECK(std::abs(here - before) < 20 * kSubvoxels);
    before = here;
  }
}

tl::expected<std::shared_ptr<const Field>, HeightsFault> scaled(const HeightMap& map,
                                                                std::optional<double> low = {},
                                                                std::optional<double> high = {}) {
  return scaled_heights(map, 1000, low, high);
}

TEST_CASE("Samples of every type come to the range between low and high") {
  const HeightMap words{2, 2, std::vector<std::uint16_t>{0, 65535, 32768, 13}};
  CHECK((*scaled(words))->values == Field::Values{0, 1000, 500, 0});
  CHECK((*scaled(words, 13.0, 32768.0))->values == Field::Values{0, 1000, 1000, 0});
  const HeightMap whole{2, 2, std::vector<std::int32_t>{-2000000000, 2000000000, 0, 1000000000}};
  CHECK((*scaled(whole))->values == Field::Values{0, 1000, 500, 750});
  const HeightMap real{2, 2, std::vector<float>{-1.5F, 2.5F, 0.5F, -1.5F}};
  CHECK((*scaled(real))->values == Field::Values{0, 1000, 500, 0});
  const HeightMap doubles{2, 2, std::vector<double>{-1.5, 2.5, 0.5, -1.5}};
  CHECK((*scaled(doubles))->values == Field::Values{0, 1000, 500, 0});
  const HeightMap bytes{2, 2, std::vector<std::uint8_t>{0, 255, 51, 102}};
  CHECK((*scaled(bytes))->values == Field::Values{0, 1000, 200, 400});
}

TEST_CASE("Samples that mark missing data flatten no land") {
  const auto error = [](const HeightMap& map, std::optional<double> low = {},
                        std::optional<double> high = {}) {
    const auto heights = scaled(map, low, high);
    return heights ? "accepted" : heights.error().key + ": " + heights.error().what;
  };
  const HeightMap holes{2, 2, std::vector<std::int32_t>{5, 7, -9999, 90}};
  CHECK(error(holes) == "file: sample 0 of row 1 is -9999, which marks missing data; fill it, or give low");
  CHECK(error(holes, 0.0) == "accepted");
  CHECK(error(holes, {}, 90.0) != "accepted");
  for (const double mark : {-32768.0, -32767.0, -99999.0, -3.4028234663852886e38, -3.4e38}) {
    CAPTURE(mark);
    CHECK_THAT(error({2, 2, std::vector<double>{5, mark, 7, 8}}), Catch::Contains("give low"));
  }
  CHECK_THAT(error({2, 2, std::vector<float>{5, 3.402823466e38F, 7, 8}}), Catch::Contains("give high"));
  CHECK(error({2, 2, std::vector<float>{-9998.5F, 5, 7, 8}}) == "accepted");
}

TEST_CASE("Samples that are not heights are refused by their place") {
  const auto error = [](HeightMap map, std::optional<double> low = {}, std::optional<double> high = {}) {
    const auto heights = scaled(map, low, high);
    return heights ? "accepted" : heights.error().key + ": " + heights.error().what;
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(error({2, 2, std::vector<float>{0, 1, 2, nan}}) ==
        "file: sample 1 of row 1 is nan; only numbers are heights");
  CHECK_THAT(error({2, 2, std::vector<float>{0, std::numeric_limits<float>::infinity(), 2, 3}}),
             Catch::Contains("sample 1 of row 0 is inf"));
  CHECK_THAT(error({2, 2, std::vector<float>{4, 4, 4, 4}}),
             Catch::Contains("file: all samples are 4; give low and high"));
  CHECK_THAT(error({2, 2, std::vector<float>{1, 2, 3, 4}}, 9.0), Catch::Contains("low is 9 and high 4"));
  CHECK_THAT(error({2, 2, std::vector<float>{0, 1, 2, 3}}, 0.0, 1e-310),
             Catch::Contains("high: low is 0 and high 1e-310; high must be at least 1e-290 above low"));
  CHECK(error({2, 2, std::vector<float>{0, 1, 2, 3}}, 0.0, 1e-290) == "accepted");
  CHECK_THAT(error({1, 4, std::vector<float>{1, 2, 3, 4}}), Catch::Contains("1 x 4 samples"));
  CHECK_THAT(error({2, 3, std::vector<float>{1, 2, 3, 4}}),
             Catch::Contains("4 samples where its shape needs 6"));
  CHECK_THAT(error({30000, 30000, std::vector<float>{1}}), Catch::Contains("900000000 samples; at most"));
}

}  // namespace
}  // namespace talus::terrain
