#include <talus/terrain/slope.h>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include "reference.h"

namespace talus::terrain {
namespace {

TEST_CASE("Slope is equation 1 at every column that has eight neighbours") {
  CHECK(rc::check([] {
    Field heights{*rc::gen::inRange(3, 20), *rc::gen::inRange(3, 20)};
    for (std::int32_t& h : heights.values) h = *rc::gen::inRange(0, 1 << 23);
    const Field slope = slope_inside(heights);
    RC_ASSERT(slope.width == heights.width - 2);
    RC_ASSERT(slope.depth == heights.depth - 2);
    for (int z = 0; z < slope.depth; ++z) {
      for (int x = 0; x < slope.width; ++x) {
        RC_ASSERT(slope.at(x, z) == test::reference::slope(heights, x + 1, z + 1));
      }
    }
  }));
}

}  // namespace
}  // namespace talus::terrain
