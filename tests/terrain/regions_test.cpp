#include "surface/regions/regions.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include <talus/vectors/instruction_set.h>

#include "regions_reference.h"
#include "surface/regions/region_rows.h"

namespace talus::terrain {
namespace {

constexpr std::int64_t kFar = std::int64_t{1} << 36;

rc::Gen<std::int64_t> any_place() {
  return rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-20'000, 20'000),
                        rc::gen::inRange<std::int64_t>(-kFar, kFar), rc::gen::just(kFar - 512),
                        rc::gen::just(-kFar));
}

std::vector<std::int64_t> any_columns() {
  std::vector<std::int64_t> columns{*any_place()};
  const int count = *rc::gen::inRange(1, 60);
  const int step = *rc::gen::element(1, 1, 2, 4, 8, 64, 0);
  if (step > 1) columns.front() = columns.front() / step * step;
  while (static_cast<int>(columns.size()) < count) {
    columns.push_back(columns.back() + (step != 0 ? step : *rc::gen::inRange(1, 30)));
  }
  return columns;
}

RegionsSpec regions_spec() {
  RegionsSpec spec;
  spec.sea_level = 128;
  return spec;
}

RegionsSpec any_regions() {
  RegionsSpec spec = regions_spec();
  spec.mesas_anywhere = *rc::gen::element(0.0, 0.4);
  spec.temperature.warped = *rc::gen::arbitrary<bool>();
  spec.mesas.warped = *rc::gen::arbitrary<bool>();
  spec.moisture.name = *rc::gen::element<std::string>("rain", "x");
  spec.warmer = *rc::gen::inRange(-5, 6) * 0.1;
  spec.wetter = *rc::gen::inRange(-5, 6) * 0.1;
  return spec;
}

float highest_fx(const RegionsSpec& spec, int resolution) {
  return static_cast<float>(highest_land(spec) * resolution * 256);
}

std::vector<std::int32_t> heights(const Regions& regions, float highest_fx,
                                  const std::vector<std::int64_t>& xs, const std::vector<std::int64_t>& zs,
                                  InstructionSet set) {
  Surface surface;
  surface.kind = SurfaceKind::regions;
  surface.regions = std::make_shared<const Regions>(regions);
  surface.highest_fx = highest_fx;
  RegionRows rows{surface, set};
  std::vector<std::int32_t> all(xs.size() * zs.size());
  rows.start(xs);
  for (std::size_t j = 0; j < zs.size(); ++j) rows.row(zs[j], all.data() + j * xs.size());
  return all;
}

std::vector<InstructionSet> sets_here() {
  std::vector<InstructionSet> sets;
  for (const auto set : kInstructionSets) {
    if (runs_here(set)) sets.push_back(set);
  }
  return sets;
}

TEST_CASE(
    "Regions have the bits of their formulas at each column, in whatever rows, by every instruction set") {
  CHECK(rc::check([] {
    const RegionsSpec spec = any_regions();
    const int resolution = *rc::gen::element(1, 1, 2, 5);
    const Regions regions = regions_of(spec, {}, *rc::gen::arbitrary<std::uint64_t>(), resolution);
    const float highest = highest_fx(spec, resolution);
    const auto xs = any_columns();
    const std::int64_t z = *any_place();
    const std::vector<std::int64_t> zs{z, z + 1, z + 7, z + 9, z + 200, z};
    std::vector<std::int32_t> expected;
    for (const std::int64_t each_z : zs) {
      for (const std::int64_t x : xs) {
        expected.push_back(test::reference::region_height_fx(regions, highest, x, each_z));
      }
    }
    for (const InstructionSet set : sets_here())
      RC_ASSERT(heights(regions, highest, xs, zs, set) == expected);
  }));
}

TEST_CASE("Land of regions lies between the sea's floor and the highest there may be") {
  const RegionsSpec spec = regions_spec();
  const Regions regions = regions_of(spec, {}, 2019, 1);
  std::vector<std::int64_t> places;
  for (std::int64_t i = 0; i < 400; ++i) places.push_back((i - 200) * 5000);
  const auto land = heights(regions, highest_fx(spec, 1), places, places, instruction_set());
  const auto [lowest, highest] = std::minmax_element(land.begin(), land.end());
  CHECK(*lowest >= 256);
  CHECK(*lowest < (128 - 40) * 256);
  CHECK(*highest > (128 + 250) * 256);
  CHECK(static_cast<float>(*highest) < highest_fx(spec, 1));
  const auto water = std::count_if(land.begin(), land.end(), [](std::int32_t h) { return h < 128 * 256; });
  const double share = static_cast<double>(water) / static_cast<double>(land.size());
  CHECK(share > 0.3);
  CHECK(share < 0.45);
}

TEST_CASE("Neighbouring columns of regions are steep nowhere but at mesas") {
  RegionsSpec spec = regions_spec();
  spec.mesa_height = 0;
  const Regions regions = regions_of(spec, {}, 2019, 1);
  std::vector<std::int64_t> xs;
  for (std::int64_t x = 0; x < 200'000; ++x) xs.push_back(x);
  std::vector<std::int32_t> land =
      heights(regions, highest_fx(spec, 1), xs, {-70'000, 3, 1'000'000}, instruction_set());
  std::int32_t most = 0;
  for (std::size_t i = 0; i + 1 < land.size(); ++i) {
    if ((i + 1) % xs.size() != 0) most = std::max(most, std::abs(land[i + 1] - land[i]));
  }
  CHECK(most < 15 * 256);
  CHECK(most > 256);
}

struct LevelRow {
  std::vector<std::int32_t> heights;
  std::vector<std::int32_t> slopes;
  bool operator==(const LevelRow&) const = default;
};

LevelRow level_row(const Regions& regions, float highest_fx, const std::vector<std::int64_t>& xs,
                   std::int64_t z, Lod lod, InstructionSet set) {
  Surface surface;
  surface.kind = SurfaceKind::regions;
  surface.regions = std::make_shared<const Regions>(regions);
  surface.highest_fx = highest_fx;
  RegionRows rows{surface, set};
  LevelRow row{std::vector<std::int32_t>(xs.size()), std::vector<std::int32_t>(xs.size())};
  REQUIRE(rows.starts_level(xs, lod));
  rows.sloped_row(z, row.heights.data(), row.slopes.data());
  return row;
}

TEST_CASE("A coarse level has level 0's land but for rivers, and slopes near its, by every instruction set") {
  double error = 0;
  double all = 0;
  std::size_t columns = 0;
  std::size_t others = 0;
  CHECK(rc::check([&] {
    const RegionsSpec spec = any_regions();
    const Regions regions = regions_of(spec, {}, *rc::gen::arbitrary<std::uint64_t>(), 1);
    const float highest = highest_fx(spec, 1);
    const Lod lod = Lod::of(*rc::gen::inRange(1, 7));
    const std::int64_t step = std::int64_t{1} << lod.value();
    const std::int64_t first = *rc::gen::inRange<std::int64_t>(-100'000, 100'000) * step;
    const std::int64_t z = *rc::gen::inRange<std::int64_t>(-100'000, 100'000) * step;
    const int width = *rc::gen::inRange(1, 80);
    std::vector<std::int64_t> xs;
    std::vector<std::int64_t> around;
    for (int i = 0; i < width; ++i) {
      xs.push_back(first + i * step);
      around.insert(around.end(), {xs.back() - 1, xs.back(), xs.back() + 1});
    }
    const LevelRow row = level_row(regions, highest, xs, z, lod, InstructionSet::scalar);
    for (const InstructionSet set : sets_here()) {
      RC_ASSERT(level_row(regions, highest, xs, z, lod, set) == row);
    }
    // One column alone is the same as one of many.
    const LevelRow alone = level_row(regions, highest, {xs.back()}, z, lod, instruction_set());
    RC_ASSERT(alone.heights.back() == row.heights.back());
    RC_ASSERT(alone.slopes.back() == row.slopes.back());
    const auto base = heights(regions, highest, around, {z - 1, z, z + 1}, instruction_set());
    for (std::size_t i = 0; i < xs.size(); ++i) {
      const auto at = [&](std::size_t dz, std::size_t dx) { return base[dz * around.size() + 3 * i + dx]; };
      std::int32_t slope = 0;
      for (std::size_t n = 0; n < 9; ++n) slope = std::max(slope, std::abs(at(n / 3, n % 3) - at(1, 1)));
      error += (slope - row.slopes[i]) * (slope - row.slopes[i]);
      all += slope * slope;
      ++columns;
      if (row.heights[i] != at(1, 1)) ++others;
      // Rivers are widened, so that land is lowered alone.
      RC_ASSERT(row.heights[i] <= at(1, 1) + 2 * kSubvoxels);
    }
  }));
  CAPTURE(error / static_cast<double>(columns), all / static_cast<double>(columns), others, columns);
  CHECK(error < 0.25 * all);
  CHECK(others < columns);
}

TEST_CASE("A feature with another name has another seed") {
  CHECK(named_seed(1, "rivers") == named_seed(1, "rivers"));
  CHECK(named_seed(1, "rivers") != named_seed(1, "ranges"));
  CHECK(named_seed(1, "rivers") != named_seed(2, "rivers"));
}

}  // namespace
}  // namespace talus::terrain
