// Work in pieces: wherever it is cut, and whatever was begun and given up before, the result is the same.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

#include <talus/terrain/generator.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/stacks.h>

#include "features_of.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

/// By either method, with and without caves, folds and faults, and ground that is surveyed.
World any_world() {
  const std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();
  const int steps = *rc::gen::inRange(0, 6);
  if (*rc::gen::arbitrary<bool>()) return test::small_caves(seed, steps);
  const std::string method =
      steps == 0 ? "" : "method = \"erosion\"\nerosion_steps = " + std::to_string(steps) + "\n";
  const std::string lava =
      "[[lava]]\nname = \"lava\"\ncolour = \"#ff4010\"\nlow = 0\nhigh = 1\nspacing = 0.8\nradius = 0.3\n"
      "thickness = 0.4\nabundance = 0.8\npool_reach = 0.4\n";
  const std::string more = *rc::gen::arbitrary<bool>() ? test::underground_text() : lava;
  return World::parse(method + test::small_world_text(seed) + more, "any", {}, features_with_fixture())
      .value();
}

Region any_region() {
  return {*rc::gen::inRange<std::int64_t>(-3000, 3000), *rc::gen::inRange<std::int64_t>(-3000, 3000),
          *rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40), Lod::of(*rc::gen::inRange(0, 7))};
}

int any_columns() {
  return *rc::gen::element(1, 30, 100, 1000, 4096, 1 << 30);
}

void check_equal(const Stacks& made, const Stacks& whole) {
  RC_ASSERT(made.materials == whole.materials);
  RC_ASSERT(made.loose_planes == whole.loose_planes);
  RC_ASSERT(made.tops.size() == whole.tops.size());
  for (std::size_t i = 0; i < whole.tops.size(); ++i) RC_ASSERT(made.tops[i].values == whole.tops[i].values);
  RC_ASSERT(made.caves.floor.values == whole.caves.floor.values);
  RC_ASSERT(made.caves.roof.values == whole.caves.roof.values);
  RC_ASSERT(made.surveys.size() == whole.surveys.size());
  for (std::size_t i = 0; i < whole.surveys.size(); ++i) {
    RC_ASSERT(made.surveys[i].values == whole.surveys[i].values);
  }
}

TEST_CASE("Stacks do not depend on where their making is cut, nor on what was given up before") {
  CHECK(rc::check([] {
    const World world = any_world();
    Generator generator{world};
    Stacks stacks;
    for (int round = 0; round < 4; ++round) {
      generator.start(any_region(), std::move(stacks));
      for (int pieces = *rc::gen::inRange(0, 40); pieces > 0; --pieces) (void)generator.step(any_columns());
      if (*rc::gen::arbitrary<bool>()) {  // what is given up may be another's work
        Terrain terrain;
        generator.generate(any_region(), terrain);
      }
      const Region region = any_region();
      generator.start(region, {});
      while (generator.step(any_columns())) {
        if (*rc::gen::inRange(0, 8) == 0) generator = Generator{std::move(generator)};
      }
      stacks = generator.take();
      check_equal(stacks, generate_stacks(world, region));
    }
  }));
}

TEST_CASE("Objects do not depend on where their placing is cut, at any level") {
  CHECK(rc::check([] {
    const World& world = test::sample_world(*rc::gen::element<std::string>("default", "archipelago"));
    const int level = *rc::gen::inRange(0, 5);
    const Region region{*rc::gen::inRange<std::int64_t>(-2100, -1900) >> level,
                        *rc::gen::inRange<std::int64_t>(-6300, -6100) >> level, *rc::gen::inRange(1, 60),
                        *rc::gen::inRange(1, 60), Lod::of(level)};
    Generator generator{world};
    generator.start(region, {});
    while (generator.step(any_columns())) {
    }
    const auto keys = [](const Stacks& stacks) {
      std::vector<std::uint64_t> found;
      for (const PlacedObject& object : stacks.objects) {
        found.insert(found.end(), {object.kind, object.hash, static_cast<std::uint64_t>(object.y)});
      }
      return found;
    };
    RC_ASSERT(keys(generator.take()) == keys(generate_stacks(world, region)));
  }));
}

TEST_CASE("A piece is rows of ground, or one pass of one material or layer") {
  const auto pieces = [](const World& world, int columns) {
    Generator generator{world};
    generator.start({0, 0, 128, 128, Lod{}});
    int count = 1;
    while (generator.step(columns)) ++count;
    return count;
  };
  const World world = test::small_caves(1, 5);
  constexpr int kPatch = 128 * 128;
  const int coarse = pieces(world, 1 << 30);
  const int materials = static_cast<int>(world.loose().size());
  CHECK(coarse >= 2 * 5 * materials);
  CHECK(pieces(world, 4096) >= coarse + kPatch / 4096);
  CHECK(pieces(world, 1) >= coarse + 128);  // no less than a row
}

TEST_CASE("Work that was never begun, or is done, has no piece left") {
  const World world = test::small_world(1);
  Generator generator{world};
  CHECK_FALSE(generator.step());
  generator.start({0, 0, 8, 8, Lod{}});
  while (generator.step()) {
  }
  CHECK_FALSE(generator.step());
  CHECK(generator.take().tops.back().values ==
        generate_stacks(world, {0, 0, 8, 8, Lod{}}).tops.back().values);
}

TEST_CASE("Heights do not depend on where their making is cut") {
  CHECK(rc::check([] {
    const World world = any_world();
    std::vector<BaseColumn> columns;
    for (int i = *rc::gen::inRange(0, 60); i > 0; --i) {
      columns.push_back({*rc::gen::inRange<std::int64_t>(-90, 90), *rc::gen::inRange<std::int64_t>(-90, 90)});
    }
    HeightsWork work{world, columns};
    int pieces = 1;
    while (work.step(1)) ++pieces;
    // Caves take a tile's columns together.
    const bool by_tile = world.spec().method == Method::erosion || world.has_caves() || world.spec().talus;
    RC_ASSERT((pieces >= static_cast<int>(columns.size()) || by_tile));
    const std::vector<std::int32_t> heights = work.take();
    RC_ASSERT(heights == surface_heights(world, columns));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Stacks stacks = generate_stacks(world, {columns[i].x, columns[i].z, 1, 1, Lod{}});
      RC_ASSERT(heights[i] == stacks.ground_fx(0, 0));
    }
  }));
}

}  // namespace
}  // namespace talus::terrain
