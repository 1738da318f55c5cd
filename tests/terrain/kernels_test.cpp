// The kernels of every instruction set that this processor has give the bits of the scalar ones.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include <talus/vectors/instruction_set.h>
#include <talus/vectors/tables.h>

#include "any_field.h"
#include "kernels/columns.h"
#include "kernels/strata.h"
#include "loose/settle_grid.h"
#include "noise/displaced_fbm.h"
#include "noise/fbm_rows.h"
#include "noise/point_fbm.h"
#include "noise/rotated_fbm.h"
#include "surface/surface_rows.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

std::vector<InstructionSet> sets_here() {
  std::vector<InstructionSet> sets;
  for (const auto set : kInstructionSets) {
    if (runs_here(set)) sets.push_back(set);
  }
  return sets;
}

rc::Gen<std::int64_t> any_column() {
  constexpr std::int64_t kFar = std::int64_t{1} << 36;
  return rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-300, 300),
                        rc::gen::inRange<std::int64_t>(-kFar, kFar), rc::gen::just(kFar),
                        rc::gen::just(-kFar));
}

std::vector<std::int64_t> any_line() {
  std::vector<std::int64_t> line{*any_column()};
  const int count = *rc::gen::inRange(1, 150);
  const int widest = *rc::gen::element(1, 2, 64);
  for (int i = 1; i < count; ++i) line.push_back(line.back() + *rc::gen::inRange(1, widest + 1));
  return line;
}

/// Columns that are as far apart everywhere.
std::vector<std::int64_t> any_even_line() {
  std::vector<std::int64_t> line{*any_column()};
  const std::int64_t step = *rc::gen::element<std::int64_t>(1, 1, 2, 4, 8, 64, 3, 1 << 16, 1 << 17);
  const int count = *rc::gen::inRange(1, 600);
  for (int i = 1; i < count; ++i) line.push_back(line.back() + step);
  return line;
}

std::vector<float> noise_of(InstructionSet set, const Fbm& fbm, const std::vector<std::int64_t>& xs,
                            const std::vector<std::int64_t>& zs) {
  FbmRows rows{set};
  std::vector<float> all;
  rows.start(fbm, xs);
  for (const std::int64_t z : zs) {
    const float* row = rows.row(z, 0, xs.size());
    all.insert(all.end(), row, row + xs.size());
  }
  return all;
}

TEST_CASE("Noise has the same bits from every instruction set") {
  CHECK(rc::check([] {
    Fbm fbm;
    fbm.seed = *rc::gen::arbitrary<std::uint64_t>();
    fbm.period =
        *rc::gen::oneOf(rc::gen::inRange<std::int64_t>(2, 40), rc::gen::inRange<std::int64_t>(2, 1 << 24));
    fbm.octaves = *rc::gen::inRange(1, 17);
    const auto xs = any_line();
    const auto zs = any_line();
    const auto scalar = noise_of(InstructionSet::scalar, fbm, xs, zs);
    for (const InstructionSet set : sets_here()) {
      const auto vectors = noise_of(set, fbm, xs, zs);
      RC_ASSERT(std::memcmp(scalar.data(), vectors.data(), scalar.size() * sizeof(float)) == 0);
    }
  }));
}

TEST_CASE("Surfaces have the same bits from every instruction set, whatever the noise") {
  CHECK(rc::check([] {
    std::vector<float> noise;
    const std::size_t width = *rc::gen::inRange<std::size_t>(1, 100);
    for (std::size_t i = 0; i < width; ++i) {
      noise.push_back(static_cast<float>(*rc::gen::inRange(-1000000, 1000001)) * 1e-6F);
    }
    const float gain = static_cast<float>(*rc::gen::inRange(0, 1601)) * 0.01F;
    const int exponent = *rc::gen::inRange(1, 9);
    const float highest = static_cast<float>(*rc::gen::inRange(1, 8388609));
    std::vector<std::int32_t> scalar(width);
    noise_kernels(InstructionSet::scalar).shape(noise.data(), width, gain, exponent, highest, scalar.data());
    for (const InstructionSet set : sets_here()) {
      std::vector<std::int32_t> vectors(width);
      noise_kernels(set).shape(noise.data(), width, gain, exponent, highest, vectors.data());
      RC_ASSERT(vectors == scalar);
    }
  }));
}

TEST_CASE("Every kind of surface has the same bits from every instruction set") {
  CHECK(rc::check([] {
    const auto kind = *rc::gen::element<std::string>("perlin", "ridged", "warped", "blend");
    const std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
    const World world = kind == "perlin" ? test::small_world(seed) : test::small_world(seed, kind);
    const Surface surface = surface_of(world.spec());
    const auto xs = any_line();
    const std::int64_t z = *any_column();
    const auto row_of = [&](InstructionSet set) {
      const auto rows = make_surface_rows(surface, set);
      std::vector<std::int32_t> heights(xs.size());
      rows->start(xs);
      rows->row(z, heights.data());
      return heights;
    };
    const auto scalar = row_of(InstructionSet::scalar);
    for (const InstructionSet set : sets_here()) RC_ASSERT(row_of(set) == scalar);
  }));
}

TEST_CASE("Displaced noise has the bits of the noise of its points, from every instruction set") {
  CHECK(rc::check([] {
    Fbm fbm;
    fbm.seed = *rc::gen::arbitrary<std::uint64_t>();
    fbm.period =
        *rc::gen::oneOf(rc::gen::inRange<std::int64_t>(2, 40), rc::gen::inRange<std::int64_t>(2, 1 << 24));
    fbm.octaves = *rc::gen::inRange(1, 17);
    const auto xs = any_line();
    const std::int64_t z = *any_column();
    const auto reach_fx = static_cast<float>(*rc::gen::element(0, 1000, 1 << 22));
    std::vector<float> east(padded(xs.size()));
    std::vector<float> south(padded(xs.size()));
    for (std::size_t i = 0; i < xs.size(); ++i) {
      east[i] = static_cast<float>(*rc::gen::inRange(-10000, 10001)) * 1e-4F;
      south[i] = static_cast<float>(*rc::gen::inRange(-10000, 10001)) * 1e-4F;
    }
    PointFbm points{fbm};
    std::vector<float> expected;
    for (std::size_t i = 0; i < xs.size(); ++i) {
      const auto rounded = [&](float noise) {
        return static_cast<std::int64_t>(std::nearbyint(noise * reach_fx));
      };
      expected.push_back(
          points.at(xs[i] * kSubvoxels + rounded(east[i]), z * kSubvoxels + rounded(south[i])));
    }
    for (const InstructionSet set : sets_here()) {
      DisplacedFbm rows{set};
      rows.start(fbm, xs);
      const float* row = rows.row(z, east.data(), south.data(), reach_fx);
      RC_ASSERT(std::memcmp(expected.data(), row, expected.size() * sizeof(float)) == 0);
    }
  }));
}

TEST_CASE("Rotated noise has the bits of the noise of its points, from every instruction set") {
  CHECK(rc::check([] {
    RotatedNoise noise;
    noise.seed = *rc::gen::arbitrary<std::uint64_t>();
    noise.octaves = *rc::gen::inRange(1, 9);
    const std::int64_t least = std::int64_t{16} << noise.octaves;
    noise.period =
        *rc::gen::oneOf(rc::gen::inRange(least, 2 * least), rc::gen::inRange<std::int64_t>(least, 1 << 24));
    noise.gain = *rc::gen::element(0.3, 0.5, 1.0);
    noise.turn = *rc::gen::inRange(0, 8);
    const auto xs = *rc::gen::arbitrary<bool>() ? any_line() : any_even_line();
    const std::int64_t z = *any_column();
    const bool displaced = *rc::gen::arbitrary<bool>();
    const int reach = displaced ? *rc::gen::element(1, 40000, 1 << 22) : 0;
    std::vector<std::int32_t> east(padded(xs.size()));
    std::vector<std::int32_t> south(padded(xs.size()));
    std::vector<float> expected;
    std::vector<float> rises_east;
    std::vector<float> rises_south;
    std::vector<float> first;  // octave alone
    for (std::size_t i = 0; i < xs.size(); ++i) {
      east[i] = *rc::gen::inRange(-reach, reach + 1);
      south[i] = *rc::gen::inRange(-reach, reach + 1);
      const SlopedNoise sum = sloped_rotated_fbm(noise, xs[i], z, east[i], south[i]);
      expected.push_back(sum.value);
      rises_east.push_back(sum.east);
      rises_south.push_back(sum.south);
      RotatedNoise alone = noise;
      alone.octaves = 1;
      first.push_back(rotated_fbm(alone, xs[i], z, east[i], south[i]));
    }
    const Displacements by =
        displaced ? Displacements{east.data(), south.data()} : Displacements{nullptr, nullptr};
    for (const InstructionSet set : sets_here()) {
      RotatedFbm rows{set};
      rows.start(noise, xs);
      const auto same = [&](const float* row, const std::vector<float>& as) {
        return std::memcmp(as.data(), row, as.size() * sizeof(float)) == 0;
      };
      RC_ASSERT(same(rows.row(z, by), expected));
      AlignedVector<float> row(padded(xs.size()));
      rows.octave(0, z, {row.data()}, by);
      RC_ASSERT(same(row.data(), first));
      const SlopedRow sloped = rows.sloped_row(z, by);
      RC_ASSERT(same(sloped.value, expected));
      RC_ASSERT(same(sloped.east, rises_east));
      RC_ASSERT(same(sloped.south, rises_south));
    }
  }));
}

std::vector<std::int32_t> settled(InstructionSet set, const Field& thickness, std::int32_t repose) {
  SettleGrid grid{set};
  grid.start(thickness);
  grid.settle(repose);
  std::vector<std::int32_t> all;
  for (int z = 0; z < thickness.depth; ++z) {
    grid.with_row(z, [&](const auto* row) { all.insert(all.end(), row, row + thickness.width); });
  }
  return all;
}

TEST_CASE("Loose material settles to the same numbers by every instruction set, in 16 bits and in 32") {
  CHECK(rc::check([] {
    const std::int32_t most = *rc::gen::element(20, 5000, 32766, 32767, 1 << 20);
    Field thickness = any_field(*rc::gen::inRange(1, 140), *rc::gen::inRange(1, 12), most);
    if (*rc::gen::arbitrary<bool>()) {  // holes in a plain: what lies around them is bounded from far away
      for (std::int32_t& value : thickness.values) value = value > most / 50 ? most : 0;
    }
    constexpr std::int32_t kSteep = kSteepest<std::int16_t>;  // steeper is settled in 32 bits
    const std::int32_t repose =
        *rc::gen::oneOf(rc::gen::inRange(1, 300), rc::gen::inRange(1, 14668),
                        rc::gen::inRange(kSteep - 40, kSteep + 40), rc::gen::element(kSteep, kSteep + 1));
    const auto scalar = settled(InstructionSet::scalar, thickness, repose);
    for (const InstructionSet set : sets_here()) RC_ASSERT(settled(set, thickness, repose) == scalar);
  }));
}

TEST_CASE("The thickness before settling is an exact quotient, by every instruction set") {
  CHECK(rc::check([] {
    const std::int32_t max_slope = *rc::gen::inRange(1, 14668);
    const std::int32_t thickness =
        *rc::gen::oneOf(rc::gen::inRange(0, (1 << 20) + 1), rc::gen::inRange(0, 32768));
    const Field slope = any_field(*rc::gen::inRange(1, 70), 1, 2 * max_slope);
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      SettleGrid grid{set};
      grid.start(slope, thickness, max_slope);
      grid.with_row(0, [&](const auto* row) {
        for (int x = 0; x < slope.width; ++x) {
          const std::int64_t room = std::max(0, max_slope - slope.at(x, 0));
          RC_ASSERT(std::int64_t{row[x]} == thickness * room / max_slope);
        }
      });
    }
  }));
}

TEST_CASE("A share of the thickness before settling is exact, by every instruction set") {
  CHECK(rc::check([] {
    const std::int32_t max_slope = *rc::gen::oneOf(rc::gen::inRange(1, 700), rc::gen::inRange(1, 14668));
    const std::int32_t thickness = *rc::gen::oneOf(rc::gen::inRange(0, 4200), rc::gen::inRange(0, 32768));
    const std::int32_t whole = 1 << *rc::gen::inRange(11, 15);
    const int width = *rc::gen::inRange(1, 70);
    const Field slope = any_field(width, 1, 2 * max_slope);
    const Field share = any_field(width, 1, whole);
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      SettleGrid grid{set};
      grid.begin(width, 1, thickness);
      grid.start_row(0, slope.values.data(), share.values.data(), thickness, whole, max_slope);
      grid.with_row(0, [&](const auto* row) {
        for (int x = 0; x < width; ++x) {
          const std::int64_t room = std::max(0, max_slope - slope.at(x, 0));
          const std::int64_t shared = std::int64_t{thickness} * share.at(x, 0) / whole;
          RC_ASSERT(std::int64_t{row[x]} == shared * room / max_slope);
        }
      });
    }
  }));
}

TEST_CASE("The thickness before settling is exact where floats are just enough for it, for every slope") {
  // Slope and thickness whose product is 2^21 at most, and past it.
  for (const auto& [thickness, max_slope] :
       std::vector<std::pair<std::int32_t, std::int32_t>>{{1024, 239},
                                                          {1536, 284},
                                                          {4095, 512},
                                                          {4095, 513},
                                                          {2048, 1024},
                                                          {2049, 1024},
                                                          {1449, 1447},
                                                          {2, 1 << 20},
                                                          {1, (1 << 20) + 1},
                                                          {7, 299593}}) {
    Field slope{max_slope + 1, 1};
    for (int x = 0; x <= max_slope; ++x) slope.at(x, 0) = x;
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      CAPTURE(thickness, max_slope, to_string(set));
      SettleGrid grid{set};
      grid.start(slope, thickness, max_slope);
      std::int64_t wrong = 0;
      grid.with_row(0, [&](const auto* row) {
        for (int x = 0; x <= max_slope; ++x) {
          wrong += std::int64_t{row[x]} == std::int64_t{thickness} * (max_slope - x) / max_slope ? 0 : 1;
        }
      });
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("Without slopes the thickness before settling is the whole, in 16 bits and in 32") {
  for (const std::int32_t thickness : {1, 32766, 32767, 32768, 1000003, 1 << 20}) {
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      CAPTURE(thickness, to_string(set));
      SettleGrid grid{set};
      grid.start(Field{77, 2}, thickness, 313);
      grid.with_row(1, [&](const auto* row) {
        for (int x = 0; x < 77; ++x) REQUIRE(std::int32_t{row[x]} == thickness);
      });
    }
  }
}

TEST_CASE("Slopes have the same numbers from every instruction set") {
  CHECK(rc::check([] {
    const int width = *rc::gen::inRange(1, 70);
    const auto count = static_cast<std::size_t>(width);
    const Field heights = any_field(width + 2, 3, 1 << 23);
    const auto slopes = [&](InstructionSet set) {
      std::vector<std::int32_t> out(count);
      column_kernels(set).slope(heights.row(0).data(), heights.row(1).data(), heights.row(2).data(), count,
                                out.data());
      return out;
    };
    const auto scalar = slopes(InstructionSet::scalar);
    for (const InstructionSet set : sets_here()) RC_ASSERT(slopes(set) == scalar);
  }));
}

// The layer over one column, as LayerShape has it.
std::int32_t stacked(float noise, const LayerShape& shape, std::int32_t below, std::int32_t limit) {
  const float thickness = shape.mean_fx * std::max(0.0F, 1.0F + shape.swing * noise);
  return std::min(below + static_cast<std::int32_t>(std::nearbyint(std::min(thickness, shape.max_fx))),
                  limit);
}

TEST_CASE("A layer is laid by every instruction set as by the definition, on open ground") {
  CHECK(rc::check([] {
    const auto xs = any_line();
    const auto width = static_cast<int>(xs.size());
    const std::int64_t z = *any_column();
    const Field limit = any_field(width, 1, 1 << 23);
    Field below = any_field(width, 1, *rc::gen::element(1 << 10, 1 << 23));
    const LayerShape shape{static_cast<float>(*rc::gen::inRange(1, 1 << 22)),
                           static_cast<float>(*rc::gen::inRange(0, 33)), 8388608.0F};
    const Fbm fbm{*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange<std::int64_t>(8, 400), 4};
    std::vector<std::uint8_t> open(xs.size() / kSegment + 1);
    for (auto& segment : open) segment = *rc::gen::element<std::uint8_t>(0, 1);
    for (std::size_t x = 0; x < xs.size(); ++x) {
      const bool is_open = open[x / kSegment] != 0;
      below.values[x] = is_open ? std::min(below.values[x], limit.values[x]) : limit.values[x];
    }
    for (const InstructionSet set : sets_here()) {
      FbmRows rows{set};
      rows.start(fbm, xs);
      auto left = open;
      std::vector<std::int32_t> tops(xs.size() + 1, -1);  // one more, that nothing may touch
      const auto row_at = [&](std::int64_t row_z) {
        const float* const row = rows.row(row_z);
        return std::vector<float>(row, row + xs.size());
      };
      const std::vector<float> noise = row_at(z);
      const auto octaves = rows.octaves(z);
      const bool any =
          strata_kernels(set).stack(octaves.data(), octaves.size(), shape, xs.size(), limit.values.data(),
                                    below.values.data(), left.data(), tops.data());
      RC_ASSERT(tops.back() == -1);
      bool any_expected = false;
      for (std::size_t first = 0; first < xs.size(); first += kSegment) {
        const std::size_t segment = first / kSegment;
        bool missing = false;
        for (std::size_t x = first; x < std::min(first + kSegment, xs.size()); ++x) {
          const std::int32_t top = stacked(noise[x], shape, below.values[x], limit.values[x]);
          RC_ASSERT(tops[x] == top);
          missing = missing || top < limit.values[x];
        }
        const bool whole = first + kSegment <= xs.size();
        const bool is_left = left[segment] != 0;
        RC_ASSERT((is_left == missing || (!whole && segment > 0 && left[segment - 1] != 0)));
        any_expected = any_expected || missing;
      }
      RC_ASSERT(any == any_expected);
    }
  }));
}

}  // namespace

TEST_CASE("Layers between lines are laid by every instruction set one upon the other") {
  CHECK(rc::check([] {
    const auto width = static_cast<std::size_t>(*rc::gen::inRange(1, 200));
    const auto columns = static_cast<int>(width);
    const Field limit = any_field(columns, 1, 1 << 20);
    Field below = any_field(columns, 1, *rc::gen::element(1 << 10, 1 << 20));
    std::vector<std::uint8_t> open((width + kSegment - 1) / kSegment);
    for (auto& segment : open) segment = *rc::gen::element<std::uint8_t>(0, 1);
    for (std::size_t x = 0; x < width; ++x) {
      const bool is_open = open[x / kSegment] != 0;
      below.values[x] = is_open ? std::min(below.values[x], limit.values[x]) : limit.values[x];
    }
    const auto count = static_cast<std::size_t>(*rc::gen::inRange(1, 6));
    const RowBetween row{0, static_cast<float>(*rc::gen::inRange(0, 8)) / 8, 0};
    const float widest = *rc::gen::element(0.25F, 2.0F);  // where none, or some, is cut at 0
    std::vector<std::vector<float>> noises(count);
    std::vector<std::vector<float>> rises(count);
    std::vector<std::vector<std::int32_t>> expected(count, std::vector<std::int32_t>(width));
    std::vector<LayerShape> shapes;
    std::size_t expected_taken = 0;  // where all columns of all segments are full
    for (std::size_t i = 0; i < count; ++i) {
      shapes.push_back({static_cast<float>(*rc::gen::inRange(1, 1 << 19)),
                        widest * static_cast<float>(*rc::gen::inRange(0, 3)), 1048576.0F});
      for (std::size_t x = 0; x < width; ++x) {
        noises[i].push_back(static_cast<float>(*rc::gen::inRange(-100, 100)) / 100);
        rises[i].push_back(static_cast<float>(*rc::gen::inRange(-100, 100)) / 100 - noises[i][x]);
        const float noise = noises[i][x] + row.share * rises[i][x];
        const std::int32_t lies_on = i == 0 ? below.values[x] : expected[i - 1][x];
        expected[i][x] = stacked(noise, shapes[i], lies_on, limit.values[x]);
        const bool missing = expected[i][x] < limit.values[x];
        if (open[x / kSegment] != 0) expected_taken = std::max(expected_taken, i + (missing ? 2 : 1));
      }
    }
    for (const InstructionSet set : sets_here()) {
      std::vector<std::vector<std::int32_t>> tops(count, std::vector<std::int32_t>(width + 1, -1));
      std::vector<LinedLayer> layers;
      for (std::size_t i = 0; i < count; ++i) {
        layers.push_back({shapes[i], noises[i].data(), rises[i].data(), tops[i].data()});
      }
      auto left = open;
      const std::size_t taken = strata_kernels(set).stack_between(
          layers.data(), count, row, width, limit.values.data(), below.values.data(), left.data());
      for (std::size_t i = 0; i < count; ++i) {
        RC_ASSERT(tops[i].back() == -1);
        tops[i].pop_back();
        RC_ASSERT(tops[i] == expected[i]);
      }
      const bool any_left = std::find(left.begin(), left.end(), 1) != left.end();
      RC_ASSERT(any_left == (taken == count + 1));
      RC_ASSERT(taken == 0 || expected_taken == 0 || taken <= expected_taken);
    }
  }));
}

TEST_CASE("Layers that end under the limit are laid by every instruction set one upon the other") {
  CHECK(rc::check([] {
    const auto width = static_cast<std::size_t>(*rc::gen::inRange(1, 200));
    const auto columns = static_cast<int>(width);
    const Field below = any_field(columns, 1, 1 << 18);
    Field limit = any_field(columns, 1, 1 << 18);
    const auto count = static_cast<std::size_t>(*rc::gen::inRange(0, 6));
    const RowBetween row{0, static_cast<float>(*rc::gen::inRange(0, 8)) / 8, 0};
    std::vector<std::vector<float>> noises(count);
    std::vector<std::vector<float>> rises(count);
    std::vector<std::vector<std::int32_t>> expected(count, std::vector<std::int32_t>(width));
    std::vector<LayerShape> shapes;
    std::int32_t bound_fx = 0;
    for (std::size_t i = 0; i < count; ++i) {
      shapes.push_back({static_cast<float>(*rc::gen::inRange(1, 1 << 16)),
                        0.25F * static_cast<float>(*rc::gen::inRange(0, 3)), 1048576.0F});
      RC_ASSERT(shapes[i].is_bounded());
      bound_fx += shapes[i].bound_fx();
      for (std::size_t x = 0; x < width; ++x) {
        noises[i].push_back(static_cast<float>(*rc::gen::inRange(-100, 101)) / 100);
        rises[i].push_back(static_cast<float>(*rc::gen::inRange(-100, 101)) / 100 - noises[i][x]);
        const float noise = noises[i][x] + row.share * rises[i][x];
        expected[i][x] = stacked(noise, shapes[i], i == 0 ? below.values[x] : expected[i - 1][x], 1 << 24);
      }
    }
    std::int32_t room = 1 << 24;
    for (std::size_t x = 0; x < width; ++x) {
      limit.values[x] += below.values[x] + bound_fx;
      const std::int32_t reached = count == 0 ? below.values[x] : expected[count - 1][x];
      RC_ASSERT(reached <= below.values[x] + bound_fx);
      room = std::min(room, limit.values[x] - reached);
    }
    for (const InstructionSet set : sets_here()) {
      std::vector<std::vector<std::int32_t>> tops(count, std::vector<std::int32_t>(width + 1, -1));
      std::vector<LinedLayer> layers;
      for (std::size_t i = 0; i < count; ++i) {
        layers.push_back({shapes[i], noises[i].data(), rises[i].data(), tops[i].data()});
      }
      RC_ASSERT(strata_kernels(set).stack_inside(layers.data(), count, row, width, limit.values.data(),
                                                 below.values.data()) == room);
      for (std::size_t i = 0; i < count; ++i) {
        RC_ASSERT(tops[i].back() == -1);
        tops[i].pop_back();
        RC_ASSERT(tops[i] == expected[i]);
      }
    }
  }));
}

}  // namespace talus::terrain
