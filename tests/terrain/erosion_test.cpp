#include <talus/terrain/erosion.h>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <regex>
#include <set>

#include <talus/terrain/generator.h>
#include <talus/terrain/heights.h>

#include "reference.h"
#include "worlds.h"
#include "wrong_spec.h"

namespace talus::terrain {
namespace {

std::int64_t sum(const Field& field) {
  return std::accumulate(field.values.begin(), field.values.end(), std::int64_t{0});
}

std::int64_t squares(const Field& field) {
  std::int64_t sum = 0;
  for (const std::int64_t value : field.values) sum += value * value;
  return sum;
}

/// Rough ground, or level with towers and pits.
Field any_surface() {
  Field surface{*rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20)};
  const int most = *rc::gen::element(50, 2000, 60000);
  const bool towers = *rc::gen::arbitrary<bool>();
  for (std::int32_t& height : surface.values) {
    height = towers ? (*rc::gen::inRange(0, 6) == 0 ? most : 0) : *rc::gen::inRange(0, most + 1);
  }
  return surface;
}

std::vector<LooseRules> any_rules(int max_materials) {
  std::vector<LooseRules> rules;
  for (int count = *rc::gen::inRange(1, max_materials + 1); count > 0; --count) {
    rules.push_back(
        {*rc::gen::inRange(0, 3000), *rc::gen::oneOf(rc::gen::inRange(4, 40), rc::gen::inRange(4, 14668))});
  }
  return rules;
}

Neighbours any_neighbours() {
  return *rc::gen::element(Neighbours::all, Neighbours::von_neumann, Neighbours::diagonal);
}

TEST_CASE("A step of erosion is what its definition says, whatever the order of columns") {
  CHECK(rc::check([] {
    const auto rules = any_rules(3);
    const Neighbours neighbours = any_neighbours();
    LooseGround quick;
    set_loose(any_surface(), rules, quick);
    LooseGround slow = quick;
    Eroder eroder{neighbours};
    for (int i = 0; i < 4; ++i) {
      (void)eroder.step(rules, quick);
      test::reference::erode_step(rules, neighbours, slow);
      for (std::size_t m = 0; m < rules.size(); ++m) {
        RC_ASSERT(quick.thickness[m].values == slow.thickness[m].values);
      }
    }
  }));
}

TEST_CASE("Setting loose keeps the surface and takes the lightest first") {
  CHECK(rc::check([] {
    const Field surface = any_surface();
    const auto rules = any_rules(3);
    LooseGround ground;
    set_loose(surface, rules, ground);
    RC_ASSERT(ground.surface().values == surface.values);
    for (std::size_t i = 0; i < surface.values.size(); ++i) {
      std::int32_t left = surface.values[i];
      for (std::size_t m = rules.size(); m-- > 0;) {
        RC_ASSERT(ground.thickness[m].values[i] == std::min(left, rules[m].t_fx));
        left -= ground.thickness[m].values[i];
      }
      RC_ASSERT(ground.base.values[i] == left);
    }
  }));
}

TEST_CASE("Erosion keeps every material to the last subvoxel and takes only existing material") {
  CHECK(rc::check([] {
    const auto rules = any_rules(3);
    LooseGround ground;
    set_loose(any_surface(), rules, ground);
    const LooseGround before = ground;
    Eroder eroder{any_neighbours()};
    for (int i = 0; i < 20; ++i) (void)eroder.step(rules, ground);
    RC_ASSERT(ground.base.values == before.base.values);
    for (std::size_t m = 0; m < rules.size(); ++m) {
      RC_ASSERT(sum(ground.thickness[m]) == sum(before.thickness[m]));
      RC_ASSERT(*std::min_element(ground.thickness[m].values.begin(), ground.thickness[m].values.end()) >= 0);
    }
  }));
}

TEST_CASE("With each step of one material the squared heights fall by at least what moved") {
  CHECK(rc::check([] {
    const auto rules = any_rules(1);
    LooseGround ground;
    set_loose(any_surface(), rules, ground);
    Eroder eroder{any_neighbours()};
    for (int i = 0; i < 50; ++i) {
      const Field before = ground.surface();
      if (!eroder.step(rules, ground)) break;
      const Field after = ground.surface();
      std::int64_t moved = 0;  // no more than left its column for good
      for (std::size_t k = 0; k < after.values.size(); ++k) {
        moved += std::max(0, before.values[k] - after.values[k]);
      }
      RC_ASSERT(squares(before) - squares(after) >= std::max<std::int64_t>(1, moved));
    }
  }));
}

TEST_CASE("A map with edges comes to rest, with no loose column above a neighbour by more than repose") {
  CHECK(rc::check([] {
    const auto rules = any_rules(2);
    LooseGround ground;
    set_loose(any_surface(), rules, ground);
    Eroder eroder;
    (void)eroder.rest(rules, ground);
    Field surface = ground.base;
    for (std::size_t m = 0; m < rules.size(); ++m) {
      for (std::size_t i = 0; i < surface.values.size(); ++i) {
        surface.values[i] += ground.thickness[m].values[i];
      }
      for (int z = 0; z < surface.depth; ++z) {
        for (int x = 0; x < surface.width; ++x) {
          if (ground.thickness[m].at(x, z) == 0) continue;
          for (int nz = std::max(z - 1, 0); nz <= std::min(z + 1, surface.depth - 1); ++nz) {
            for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, surface.width - 1); ++nx) {
              RC_ASSERT(surface.at(x, z) - surface.at(nx, nz) <= rules[m].c_fx);
            }
          }
        }
      }
    }
    RC_ASSERT(eroder.rest(rules, ground) == std::int64_t(rules.size()));  // a look at each, and nothing moves
  }));
}

TEST_CASE("A larger step sends material back and forth for ever") {
  // Two columns on level ground: what one gives in a step of 2.7 c makes the other higher by more than c.
  constexpr std::int32_t c_fx = 100;
  Field thickness{2, 1};
  thickness.values = {1000, 849};
  const auto run = [](Field material, std::int32_t step_fx) {
    Eroder eroder;
    std::set<Field::Values> seen;
    bool moved = true;
    while (moved && seen.insert(material.values).second) {
      const Field surface = material;
      moved = eroder.move(surface, c_fx, step_fx, material);
    }
    return !moved;
  };
  CHECK(run(thickness, erosion_step_fx(c_fx)));
  CHECK_FALSE(run(thickness, 270));
}

std::string eroding(std::uint64_t seed, int steps) {
  return "method = \"erosion\"\nerosion_steps = " + std::to_string(steps) + "\n" +
         test::small_world_text(seed);
}

TEST_CASE("Erosion keeps within the rows that the world says it may reach") {
  const auto world = World::parse(eroding(5, 64), "w.toml");
  REQUIRE(world.has_value());
  for (const int level : {0, 3}) {
    const Terrain terrain = generate_terrain(*world, {-100, 40, 128, 128, Lod::of(level)});
    const auto highest = *std::max_element(terrain.surface.values.begin(), terrain.surface.values.end());
    CHECK(highest <= (world->highest_fx() >> level) + world->rise_fx());
  }
}

TEST_CASE("A world whose ground erosion may raise beyond the rows of a world is refused") {
  const std::regex angle{"angle_of_repose = [0-9.]+"};
  CHECK(test::error_of(std::regex_replace(eroding(5, 64), angle, "angle_of_repose = 45")) == "accepted");
  CHECK_THAT(
      test::error_of(std::regex_replace(eroding(5, 64), angle, "angle_of_repose = 89")),
      Catch::StartsWith("w.toml:2: erosion_steps: with these angles of repose the ground may rise to row "));
}

World eroded_small_world(std::uint64_t seed, int steps) {
  return World::parse(eroding(seed, steps), "w.toml").value();
}

TEST_CASE("A level runs max(1, K >> l) steps on its own columns, as the definition has them") {
  CHECK(rc::check([] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const int steps = *rc::gen::inRange(1, 65);
    const Lod lod = Lod::of(*rc::gen::inRange(0, Lod::kMax + 1));
    const World world = eroded_small_world(seed, steps);
    const int steps_here = std::max(1, steps >> lod.value());
    RC_ASSERT(world.erosion_steps_at(lod) == steps_here);
    RC_ASSERT(halo_columns(world, lod) == 2 * steps_here);

    const Region region{*rc::gen::inRange(-300, 300), *rc::gen::inRange(-300, 300), 9, 5, lod};
    const Terrain made = generate_terrain(world, region);
    const Field before = generate_terrain(test::small_world(seed), region.expanded(2 * steps_here)).surface;
    std::vector<LooseRules> rules;
    for (const std::size_t m : world.loose_bottom_up()) {
      rules.push_back({world.loose()[m].thickness_at(lod), world.loose()[m].c_fx});
    }
    LooseGround ground;
    set_loose(before, rules, ground);
    for (int i = 0; i < steps_here; ++i) test::reference::erode_step(rules, Neighbours::all, ground);
    RC_ASSERT(made.surface.values == ground.surface().cropped(2 * steps_here).values);
    for (std::size_t m = 0; m < rules.size(); ++m) {
      RC_ASSERT(made.loose[world.loose_bottom_up()[m]].values ==
                ground.thickness[m].cropped(2 * steps_here).values);
    }
  }));
}

/// By how many base voxels erosion changes the height of a column of the level, in the mean.
double mean_change(int steps, Lod lod) {
  const int side = 512 >> lod.value();
  const Region region{0, 0, side, side, lod};
  const Field after = generate_terrain(eroded_small_world(4, steps), region).surface;
  const Field before = generate_terrain(test::small_world(4), region).surface;
  double sum_fx = 0;
  for (std::size_t i = 0; i < after.values.size(); ++i) {
    sum_fx += std::abs(after.values[i] - before.values[i]);
  }
  return std::ldexp(sum_fx / static_cast<double>(after.values.size()) / kSubvoxels, lod.value());
}

TEST_CASE("Erosion's changes of far ground grow less than its columns' width") {
  constexpr int kSteps = 16;
  const double at_base = mean_change(kSteps, Lod{});
  REQUIRE(at_base > 0.1);
  for (int level = 1; level <= 4; ++level) {
    const double here = mean_change(kSteps, Lod::of(level));
    INFO("level " << level << ": " << here << " voxels, level 0: " << at_base);
    CHECK(here < (1 + level) * at_base);
  }
}

TEST_CASE("Only worlds of two or more steps have generator version 3") {
  const auto version_in = [](const World& world) {
    return world.canonical_form().find("\ngenerator " +
                                       std::to_string(to_integer(world.generator_version())) + "\n") !=
           std::string::npos;
  };
  for (const int steps : {0, 1, 2, 64}) {
    INFO(steps << " steps");
    const World world = steps == 0 ? test::small_world(4) : eroded_small_world(4, steps);
    CHECK(world.generator_version() == (steps > 1 ? GeneratorVersion::v3 : GeneratorVersion::v2));
    CHECK(version_in(world));
  }
}

TEST_CASE("Heights of single columns equal the eroded surface") {
  const auto world = World::parse(eroding(9, 12), "w.toml");
  REQUIRE(world.has_value());
  const Terrain terrain = generate_terrain(*world, {-40, -10, 90, 50, Lod{}});
  std::vector<BaseColumn> columns;
  std::vector<std::int32_t> expected;
  for (int i = 0; i < 60; ++i) {
    const int x = i * 37 % 90;
    const int z = i * 11 % 50;
    columns.push_back({x - 40, z - 10});
    expected.push_back(terrain.surface.at(x, z));
  }
  CHECK(surface_heights(*world, columns) == expected);
}

TEST_CASE("Erosion moves the surface and leaves the slope method's worlds as they were") {
  const World plain = test::small_world(4);
  const auto world = World::parse(eroding(4, 16), "w.toml");
  REQUIRE(world.has_value());
  const Region region{0, 0, 64, 64, Lod{}};
  CHECK(generate_terrain(*world, region).surface.values != generate_terrain(plain, region).surface.values);
  CHECK(world->fingerprint() != plain.fingerprint());
  const auto slope = World::parse("method = \"slope\"\n" + test::small_world_text(4), "w.toml");
  REQUIRE(slope.has_value());
  CHECK(slope->fingerprint() == plain.fingerprint());
}

}  // namespace
}  // namespace talus::terrain
