// Ridged and warped surfaces beside their references.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numeric>

#include <talus/terrain/heights.h>
#include <talus/terrain/surface.h>

#include "reference.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

constexpr std::int64_t kFar = std::int64_t{1} << 36;

rc::Gen<std::int64_t> any_column() {
  return rc::gen::oneOf(
      rc::gen::inRange<std::int64_t>(-kFar, kFar), rc::gen::inRange<std::int64_t>(-300, 300),
      rc::gen::inRange<std::int64_t>(kFar - 100, kFar), rc::gen::inRange<std::int64_t>(-kFar, 100 - kFar));
}

WorldSpec any_spec(SurfaceKind kind) {
  WorldSpec spec;
  spec.seed = *rc::gen::arbitrary<std::uint64_t>();
  spec.resolution = *rc::gen::inRange(20, 400);
  spec.surface.kind = kind;
  spec.surface.wavelength = *rc::gen::inRange(1, 50) * 0.25 + 1;
  spec.surface.octaves = *rc::gen::inRange(1, 9);
  spec.surface.gain = *rc::gen::inRange(0, 30) * 0.1;
  spec.surface.exponent = *rc::gen::inRange(1, 5);
  spec.surface.amplitude = *rc::gen::inRange(1, 40) * 0.1;
  spec.surface.feedback = *rc::gen::inRange(0, 161) * 0.1;
  spec.surface.warp = *rc::gen::inRange(0, 40) * 0.1;
  spec.surface.warp_wavelength = *rc::gen::inRange(1, 50) * 0.25;
  spec.surface.warp_octaves = *rc::gen::inRange(1, 5);
  return spec;
}

std::vector<std::int32_t> row_of(const Surface& surface, const std::vector<std::int64_t>& xs,
                                 std::int64_t z) {
  std::vector<std::int32_t> heights(xs.size());
  sample_surface(surface, xs, std::array{z}, heights);
  return heights;
}

std::vector<std::int64_t> line(std::int64_t first, std::size_t count) {
  std::vector<std::int64_t> xs(count);
  std::iota(xs.begin(), xs.end(), first);
  return xs;
}

// What an error of the noise comes to in subvoxels, and half of one for rounding.
double tolerance_fx(const WorldSpec& spec, const Surface& surface, double noise_error) {
  return 1 + (noise_error * spec.surface.gain * spec.surface.exponent + 1e-6) * surface.highest_fx;
}

TEST_CASE("A ridged surface is Musgrave's ridged multifractal within float rounding") {
  CHECK(rc::check([] {
    const WorldSpec spec = any_spec(SurfaceKind::ridged);
    const Surface surface = surface_of(spec);
    const auto xs = line(*any_column(), 20);
    const std::int64_t z = *any_column();
    const auto heights = row_of(surface, xs, z);
    for (std::size_t i = 0; i < xs.size(); ++i) {
      const double noise = test::reference::ridges(surface.noise, spec.surface.feedback, xs[i], z);
      const double exact = test::reference::surface_fx(spec, noise);
      RC_ASSERT(std::abs(heights[i] - exact) <= tolerance_fx(spec, surface, 2e-5));
    }
  }));
}

TEST_CASE("A warped surface is fBm where two other noises say, within a subvoxel of displacement") {
  CHECK(rc::check([] {
    const WorldSpec spec = any_spec(SurfaceKind::warped);
    const Surface surface = surface_of(spec);
    const auto xs = line(*any_column(), 20);
    const std::int64_t z = *any_column();
    const auto heights = row_of(surface, xs, z);
    // The noise's rise over the half subvoxel, along each axis, that a displacement is rounded by, and over
    // what float32 makes of the displacement itself.
    const double misplaced = 1.0 / 512 + 4e-6 * static_cast<double>(surface.warp.reach_fx) / 256;
    const double rise = 2 * 2.8 * spec.surface.octaves / static_cast<double>(surface.noise.period);
    for (std::size_t i = 0; i < xs.size(); ++i) {
      const double exact = test::reference::surface_fx(spec, test::reference::warped(surface, xs[i], z));
      RC_ASSERT(std::abs(heights[i] - exact) <= tolerance_fx(spec, surface, 4e-6 + rise * misplaced));
    }
  }));
}

TEST_CASE("A warp of nothing leaves fBm where it was, and a feedback of nothing one octave of ridges") {
  WorldSpec spec = test::small_world(5, "warped").spec();
  spec.surface.warp = 0;
  WorldSpec plain = spec;
  plain.surface.kind = SurfaceKind::perlin;
  const auto warped = row_of(surface_of(spec), line(-40, 90), 17);
  const auto perlin = row_of(surface_of(plain), line(-40, 90), 17);
  for (std::size_t i = 0; i < warped.size(); ++i) CHECK(std::abs(warped[i] - perlin[i]) <= 2);

  WorldSpec ridged = test::small_world(5, "ridged").spec();
  ridged.surface.feedback = 0;
  Surface one = surface_of(ridged);
  const auto flat = row_of(one, line(-40, 90), 17);
  for (std::size_t i = 0; i < flat.size(); ++i) {
    Fbm first = one.noise;
    first.octaves = 1;
    const double share = 1 / (2 - 1 / 16.0);  // of five octaves
    const double noise =
        (test::reference::ridges(first, 0, -40 + static_cast<std::int64_t>(i), 17) + 0.5) * share;
    CHECK(flat[i] == Approx(test::reference::surface_fx(ridged, noise - 0.5)).margin(4));
  }
}

TEST_CASE("A row of any surface has the bits of its columns one by one, at both ends of the world too") {
  CHECK(rc::check([] {
    const auto kind = *rc::gen::element<std::string>("ridged", "warped", "mirror", "sea", "repeat", "blend");
    const World world = test::small_world(*rc::gen::arbitrary<std::uint64_t>(), kind);
    const Surface surface = surface_of(world.spec());
    const auto xs = line(*any_column(), static_cast<std::size_t>(*rc::gen::inRange(1, 60)));
    const auto zs = line(*any_column(), 5);
    std::vector<std::int32_t> heights(xs.size() * zs.size());
    sample_surface(surface, xs, zs, heights);
    for (std::size_t j = 0; j < zs.size(); ++j) {
      for (std::size_t i = 0; i < xs.size(); ++i) {
        const BaseColumn column{xs[i], zs[j]};
        RC_ASSERT(surface_heights(world, {&column, 1}).front() == heights[j * xs.size() + i]);
        RC_ASSERT(heights[j * xs.size() + i] >= 0);
        RC_ASSERT(heights[j * xs.size() + i] <= world.highest_fx());
      }
    }
  }));
}

TEST_CASE("A warped surface is as fine at the world's ends as at its origin") {
  WorldSpec spec = test::small_world(9, "warped").spec();
  spec.resolution = 2000;
  const Surface surface = surface_of(spec);
  for (const std::int64_t x : {std::int64_t{0}, kFar - 4000, -kFar}) {
    const auto heights = row_of(surface, line(x, 4000), x);
    double steepest = 0;
    std::size_t level = 0;
    for (std::size_t i = 1; i < heights.size(); ++i) {
      steepest = std::max(steepest, std::abs(static_cast<double>(heights[i] - heights[i - 1])));
      level += heights[i] == heights[i - 1] ? 1U : 0U;
    }
    INFO("x " << x);
    CHECK(steepest > 50);
    CHECK(steepest < 12 * kSubvoxels);  // no cliffs where positions lose their fractions
    CHECK(level < heights.size() / 2);  // and no stairs
  }
}

}  // namespace
}  // namespace talus::terrain
