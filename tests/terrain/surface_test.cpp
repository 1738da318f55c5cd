#include <talus/terrain/surface.h>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <cmath>

#include "reference.h"

namespace talus::terrain {
namespace {

TEST_CASE("The surface is the noise, raised, cut off and scaled, rounded to a subvoxel") {
  CHECK(rc::check([] {
    WorldSpec spec;
    spec.seed = *rc::gen::arbitrary<std::uint64_t>();
    spec.resolution = *rc::gen::inRange(1, 500);
    spec.surface.wavelength = *rc::gen::inRange(1, 50) * 0.25 + 1;
    spec.surface.octaves = *rc::gen::inRange(1, 9);
    spec.surface.gain = *rc::gen::inRange(0, 40) * 0.1;
    spec.surface.exponent = *rc::gen::inRange(1, 9);
    spec.surface.amplitude = *rc::gen::inRange(1, 640) * 0.1;
    const Surface surface = surface_of(spec);
    std::vector<std::int64_t> xs{*rc::gen::inRange<std::int64_t>(-1000000, 1000000)};
    for (int i = 1; i < 20; ++i) xs.push_back(xs.back() + 1);
    const std::vector<std::int64_t> zs{*rc::gen::inRange<std::int64_t>(-1000000, 1000000)};
    std::vector<std::int32_t> heights(xs.size());
    sample_surface(surface, xs, zs, heights);
    std::vector<float> noise(xs.size());
    sample_fbm(surface.noise, xs, zs, noise);
    // Half a subvoxel of rounding, and what float32 makes of up to a dozen operations.
    const double tolerance = 0.5 + 16 * 6e-8 * surface.highest_fx;
    for (std::size_t i = 0; i < xs.size(); ++i) {
      const double exact = test::reference::surface_fx(spec, noise[i]);
      RC_ASSERT(std::abs(heights[i] - exact) <= tolerance);
      RC_ASSERT(heights[i] >= 0);
      RC_ASSERT(heights[i] <= surface.highest_fx + 0.5);
    }
  }));
}

}  // namespace
}  // namespace talus::terrain
