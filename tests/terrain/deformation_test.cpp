#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include <talus/terrain/generator.h>
#include <talus/vectors/instruction_set.h>

#include "feature.h"
#include "features/faults.h"
#include "features_of.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

const std::string kFolds =
    "[folds]\namplitude = 0.6\nwavelength = 1.6\noctaves = 2\nstrike = 30\nstretch = 4\n";
const std::string kFaults =
    "[[faults]]\nstrike = 20\nspacing = 0.9\nthrow = 0.5\n[[faults]]\nstrike = 115\nspacing = 1.7\nthrow = "
    "0.4\n";

World world_with(std::uint64_t seed, const std::string& more) {
  return World::parse(test::small_world_text(seed) + more, "deformed").value();
}

Field lift_of(const World& world, const std::vector<std::int64_t>& xs, const std::vector<std::int64_t>& zs) {
  Field lift{static_cast<int>(xs.size()), static_cast<int>(zs.size())};
  for (const auto& feature : world.features()) {
    if (const auto deformation = feature->make_deformation(instruction_set())) deformation->add(xs, zs, lift);
  }
  return lift;
}

std::vector<std::int64_t> line(std::int64_t first, int count, std::int64_t step = 1) {
  std::vector<std::int64_t> columns;
  for (int i = 0; i < count; ++i) columns.push_back(first + i * step);
  return columns;
}

std::int64_t any_column() {
  constexpr std::int64_t kEnd = std::int64_t{1} << 36;
  return *rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-4000, 4000), rc::gen::inRange(-kEnd, kEnd),
                         rc::gen::inRange(kEnd - 3000, kEnd), rc::gen::inRange(-kEnd, -kEnd + 3000));
}

TEST_CASE("Deformed strata are the level ones, lifted or sunk whole and cut at the ground and at y = 0") {
  CHECK(rc::check([] {
    const std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
    const World level = world_with(seed, "");
    const World deformed = world_with(seed, test::underground_text());
    const Lod lod = Lod::of(*rc::gen::inRange(0, 3));
    const Region region{any_column() >> lod.value(), any_column() >> lod.value(), 24, 9, lod};
    const Terrain flat = generate_terrain(level, region);
    const Terrain terrain = generate_terrain(deformed, region);
    RC_ASSERT(terrain.surface.values == flat.surface.values);
    const std::int64_t step = std::int64_t{1} << lod.value();
    const Field lift = lift_of(deformed, line(region.x * step, 24, step), line(region.z * step, 9, step));
    // Of a layer that reached the level world's ground nothing more is known.
    for (std::size_t i = 0; i < lift.values.size(); ++i) {
      const std::int32_t ground = flat.surface.values[i];
      for (std::size_t p = 0; p + 1 < flat.strata.size(); ++p) {
        const std::int32_t before = flat.strata[p].values[i];
        if (before >= ground) break;
        RC_ASSERT(terrain.strata_materials[p] == flat.strata_materials[p]);
        if (lod.value() > 0) {
          RC_ASSERT(std::abs(terrain.strata[p].values[i] -
                             std::clamp(before + (lift.values[i] >> lod.value()), 0, ground)) <= 1);
        } else {
          RC_ASSERT(terrain.strata[p].values[i] == std::clamp(before + lift.values[i], 0, ground));
        }
      }
    }
  }));
}

TEST_CASE("Deformed strata fill the ground: planes in order, not under y = 0, the last at the surface") {
  CHECK(rc::check([] {
    const World deformed = world_with(*rc::gen::arbitrary<std::uint64_t>(), test::underground_text());
    const Terrain terrain = generate_terrain(deformed, {any_column(), any_column(), 40, 40, Lod{}});
    Field::Values below(terrain.region.columns(), 0);
    for (const Field& plane : terrain.strata) {
      for (std::size_t i = 0; i < below.size(); ++i) RC_ASSERT(plane.values[i] >= below[i]);
      below = plane.values;
    }
    RC_ASSERT(below == terrain.surface.values);
  }));
}

TEST_CASE("Sunk strata do not run out before the highest surface") {
  const World world = world_with(3, "[folds]\namplitude = 2\nwavelength = 3\n");
  std::int64_t sum = 0;
  for (const StratumSpec& layer : world.strata()) sum += layer.thickness_q16;
  CHECK(sum >= static_cast<std::int64_t>((1.25 * 2.5 + 2) * 65536));
  std::int64_t level_sum = 0;
  const World level = test::small_world(3);
  for (const StratumSpec& layer : level.strata()) level_sum += layer.thickness_q16;
  CHECK(level_sum < sum);
}

TEST_CASE("The lift of strata is a function of the column alone") {
  CHECK(rc::check([] {
    const World world = world_with(*rc::gen::arbitrary<std::uint64_t>(), test::underground_text());
    const std::int64_t x = any_column();
    const std::int64_t z = any_column();
    const std::int64_t step = std::int64_t{1} << *rc::gen::inRange(0, 7);
    const int i = *rc::gen::inRange(0, 30);
    const int j = *rc::gen::inRange(0, 20);
    const Field many = lift_of(world, line(x, 30, step), line(z, 20, step));
    const Field one = lift_of(world, {x + i * step}, {z + j * step});
    RC_ASSERT(one.at(0, 0) == many.at(i, j));
  }));
}

TEST_CASE("Folds keep within their amplitude and use it both ways") {
  const World world = world_with(7, kFolds);
  const Field lift = lift_of(world, line(-1000, 500, 8), line(-1000, 500, 8));
  const auto [low, high] = std::minmax_element(lift.values.begin(), lift.values.end());
  const std::int32_t amplitude_fx = static_cast<std::int32_t>(0.6 * 40 * 256) + 1;
  CHECK(*low >= -amplitude_fx);
  CHECK(*high <= amplitude_fx);
  CHECK(*low < -amplitude_fx / 2);
  CHECK(*high > amplitude_fx / 2);
}

TEST_CASE("Folds are longer along their strike than across it") {
  const World world =
      world_with(7, "[folds]\namplitude = 1\nwavelength = 1.6\noctaves = 1\nstrike = 90\nstretch = 6\n");
  const Field lift = lift_of(world, line(-2000, 600, 8), line(-2000, 600, 8));
  double along = 0;
  double across = 0;
  for (int i = 0; i + 1 < 600; ++i) {
    for (int j = 0; j + 1 < 600; ++j) {
      along += std::abs(lift.at(i + 1, j) - lift.at(i, j));  // strike 90: east
      across += std::abs(lift.at(i, j + 1) - lift.at(i, j));
    }
  }
  CHECK(across > 3 * along);
}

TEST_CASE("Folds are smooth: no column lies far from its neighbours, however far out") {
  const World world = world_with(7, kFolds);
  const std::int64_t end = (std::int64_t{1} << 36) - 300;
  for (const std::int64_t place : {std::int64_t{-150}, end, -end - 300}) {
    const Field lift = lift_of(world, line(place, 300), line(place, 300));
    std::int32_t steepest = 0;
    for (int i = 0; i + 1 < 300; ++i) {
      for (int j = 0; j < 300; ++j)
        steepest = std::max(steepest, std::abs(lift.at(i + 1, j) - lift.at(i, j)));
    }
    CHECK(steepest > 0);
    CHECK(steepest < 5 * 256);
  }
}

TEST_CASE(
    "A fault's block is the floor of its distance across the strike over the spacing, at any distance") {
  CHECK(rc::check([] {
    const World world = world_with(*rc::gen::arbitrary<std::uint64_t>(), kFaults);
    const std::int64_t x = any_column();
    const std::int64_t z = any_column();
    std::int64_t lift = 0;
    for (std::size_t set = 0; set < 2; ++set) {
      const FaultField faults = test::feature_of<Faults>(world).sets()[set];
      // An x87 long double holds all of it.
      const long double across =
          static_cast<long double>(x) * static_cast<long double>(faults.strike.cos_q16) +
          static_cast<long double>(z) * static_cast<long double>(faults.strike.sin_q16);
      const long double index = std::floor(across / static_cast<long double>(faults.spacing_q16));
      lift += faults.lift_fx(static_cast<std::int64_t>(index));
    }
    RC_ASSERT(lift_of(world, {x}, {z}).at(0, 0) == lift);
  }));
}

TEST_CASE("Within a block of every set columns differ by the fold alone") {
  const World both = world_with(5, kFolds + kFaults);
  const World folded = world_with(5, kFolds);
  const auto columns = line(-400, 800);
  const Field with = lift_of(both, columns, columns);
  const Field without = lift_of(folded, columns, columns);
  std::set<std::int32_t> offsets;
  int steps = 0;
  for (int z = 0; z < 800; ++z) {
    for (int x = 0; x < 800; ++x) {
      const std::int32_t offset = with.at(x, z) - without.at(x, z);
      offsets.insert(offset);
      if (x > 0 && offset != with.at(x - 1, z) - without.at(x - 1, z)) ++steps;
    }
  }
  CHECK(offsets.size() < 600);  // blocks, not columns
  CHECK(offsets.size() > 50);
  CHECK(steps < 800 * 40);
  CHECK(steps > 800 * 10);
}

TEST_CASE("Two blocks of a set are offset by no more than its throw, and by more than half of it somewhere") {
  const World world = world_with(11, kFaults);
  const FaultField faults = test::feature_of<Faults>(world).sets()[0];
  std::int32_t least = 0;
  std::int32_t most = 0;
  for (std::int64_t index = -500; index < 500; ++index) {
    least = std::min(least, faults.lift_fx(index));
    most = std::max(most, faults.lift_fx(index));
  }
  CHECK(most - least <= faults.throw_fx);
  CHECK(most - least > faults.throw_fx / 2);
}

TEST_CASE("Waviness moves a fault to and fro by no more than it says") {
  const World wavy = world_with(5, "[[faults]]\nstrike = 0\nspacing = 4\nthrow = 1\nwaviness = 0.5\n");
  const auto columns = line(-1680, 3200);  // half a block before the first fault
  const Field lift = lift_of(wavy, columns, line(0, 300));
  const auto first_step = [&](int z) {
    int x = 1;
    while (lift.at(x, z) == lift.at(x - 1, z)) ++x;
    return x;
  };
  int west = 3200;
  int east = 0;
  for (int z = 0; z < 300; ++z) {
    west = std::min(west, first_step(z));
    east = std::max(east, first_step(z));
  }
  CHECK(east > west);
  CHECK(east - west <= 2 * 20 + 1);
}

}  // namespace
}  // namespace talus::terrain
