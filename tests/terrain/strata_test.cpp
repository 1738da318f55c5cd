#include <talus/terrain/strata.h>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/terrain/generator.h>
#include <talus/terrain/heights.h>

#include "reference.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

StratifiedSpec rock(std::int64_t depth_q16, std::int64_t thickness_q16) {
  StratifiedSpec spec;
  spec.depth_q16 = depth_q16;
  spec.thickness_q16 = thickness_q16;
  return spec;
}

TEST_CASE("The sequence starts with the deepest material and follows the nearest depth") {
  // Depths 10, 6, 2; thicknesses 3, 3, 1; 12 to fill. d: 10 7 4(tie 6,2: first of the spec) 1 0 -1 ...
  const std::vector<StratifiedSpec> rocks{rock(2, 1), rock(10, 3), rock(6, 3)};
  CHECK(layer_sequence(rocks, 9) == std::vector<std::size_t>{1, 2, 0, 0, 0, 0, 0, 0});
  const std::vector<StratifiedSpec> tied{rock(6, 3), rock(10, 3), rock(2, 1)};
  CHECK(layer_sequence(tied, 4) == std::vector<std::size_t>{1, 0});
}

TEST_CASE("The sequence ends with the layer at which it first reaches five quarters of the amplitude") {
  CHECK(rc::check([] {
    std::vector<StratifiedSpec> rocks;
    const int count = *rc::gen::inRange(1, 6);
    for (int i = 0; i < count; ++i)
      rocks.push_back(rock(*rc::gen::inRange(-50, 1000), *rc::gen::inRange(10, 300)));
    const std::int64_t amplitude = *rc::gen::inRange(1, 1000);
    const auto sequence = layer_sequence(rocks, amplitude);
    std::int64_t sum = 0;
    for (std::size_t j = 0; j < sequence.size(); ++j) {
      RC_ASSERT(4 * sum < 5 * amplitude);
      sum += rocks[sequence[j]].thickness_q16;
    }
    RC_ASSERT(4 * sum >= 5 * amplitude);
  }));
}

TEST_CASE("A sequence of more than 256 layers is refused") {
  CHECK(layer_sequence(std::vector{rock(0, 1)}, 204).size() == 255);
  CHECK(layer_sequence(std::vector{rock(0, 1)}, 1000).empty());
}

TEST_CASE("Every column's strata are piled up from y = 0 and cut at the surface") {
  CHECK(rc::check([] {
    const World world = test::small_world(*rc::gen::arbitrary<std::uint64_t>());
    const Region region{*rc::gen::inRange<std::int64_t>(-5000, 5000),
                        *rc::gen::inRange<std::int64_t>(-5000, 5000), *rc::gen::inRange(1, 50),
                        *rc::gen::inRange(1, 50), Lod::of(*rc::gen::inRange(0, 3))};
    const int shift = region.lod.value();
    const Terrain terrain = generate_terrain(world, region);
    for (int trial = 0; trial < 20; ++trial) {
      const int x = *rc::gen::inRange(0, region.width);
      const int z = *rc::gen::inRange(0, region.depth);
      const BaseColumn base{(region.x + x) * (1 << shift), (region.z + z) * (1 << shift)};
      const std::int32_t height = surface_heights(world, {&base, 1}).front();
      RC_ASSERT(terrain.surface.at(x, z) == height >> shift);
      const test::reference::Stack stack = test::reference::strata(world, base.x, base.z, height);
      RC_ASSERT(stack.size() == terrain.strata.size());
      for (std::size_t p = 0; p < stack.size(); ++p) {
        RC_ASSERT(terrain.strata_materials[p] == stack[p].material);
        RC_ASSERT(terrain.strata[p].at(x, z) == stack[p].top_fx >> shift);
      }
    }
  }));
}

}  // namespace
}  // namespace talus::terrain
