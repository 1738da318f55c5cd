#include <talus/terrain/land_measures.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <talus/terrain/places.h>
#include <talus/terrain/surface.h>

#include "noise/rotated_fbm.h"
#include "surface/regions/regions.h"

namespace talus::terrain {
namespace {

std::vector<std::int64_t> columns_from(std::int64_t x, std::size_t count) {
  std::vector<std::int64_t> xs(count);
  for (std::size_t i = 0; i < count; ++i) xs[i] = x + static_cast<std::int64_t>(i);
  return xs;
}

double cells(std::uint64_t position) {
  return static_cast<double>(position) / 4294967296.0;
}
/// How far from the nearest whole number, 0 to 0.5.
double from_whole(double cells) {
  return std::abs(cells - std::round(cells));
}

TEST_CASE(
    "Heights of the parts of land equal the surface, and beds of whole rivers lie in their flood plain") {
  const World& world = default_world();
  auto land = LandPartsSampler::make(world);
  auto places = PlaceSampler::make(world, {});
  REQUIRE(land);
  REQUIRE(places);
  std::size_t beds = 0;
  std::size_t terraces = 0;
  for (std::int64_t z = -40'000; z < 40'000; z += 400) {
    const auto xs = columns_from(z * 7, 700);
    land->start(xs);
    places->start(xs);
    land->row(z);
    places->row(z);
    for (std::size_t i = 0; i < xs.size(); ++i) {
      CAPTURE(xs[i], z);
      const double voxels = std::max(1.0, static_cast<double>(land->height()[i]) + 128);
      REQUIRE(places->heights_fx()[i] == Approx(voxels * kSubvoxels).margin(0.51));
      REQUIRE(land->bed()[i] >= 0);
      REQUIRE(land->terraces()[i] >= 0);
      REQUIRE(land->flood_plain()[i] >= 1.2F);
      terraces += land->terraces()[i] > 10 ? 1 : 0;
      if (land->bed()[i] <= 0 || land->river()[i] < 1) continue;
      ++beds;
      REQUIRE(land->height()[i] <= land->flood_plain()[i]);
    }
  }
  CHECK(beds > 500);
  CHECK(terraces > 500);
}

TEST_CASE("Lattice points and middles of cells are found where each noise reads them") {
  const World& world = default_world();
  const auto lattices = ShapingLattices::make(world);
  REQUIRE(lattices);
  const Surface surface = surface_of(world.spec());
  const Regions& regions = *surface.regions;
  const SlowFields& slow = regions.slow;
  struct Noise {
    const RotatedNoise* noise;
    double displaced;
  };
  const std::vector<Noise> noises{{&slow.continents.noise, 1}, {&slow.ranges.noise, 1},
                                  {&slow.hilliness.noise, 0},  {&slow.mesas.noise, 1},
                                  {&slow.rivers[0], 1},        {&regions.shape, 0.5}};
  REQUIRE(lattices->names() ==
          std::vector<std::string>{"continents", "ranges", "hilliness", "mesas", "rivers", "shape"});
  for (std::size_t i = 0; i < noises.size(); ++i) {
    const RotatedNoise& noise = *noises[i].noise;
    const RotatedLattice lattice = rotated_lattice(derived_seed(noise.seed, 0), noise.period, 0, noise.turn);
    const double within = 2.0 / static_cast<double>(noise.period);  // two columns
    int found = 0;
    for (std::int64_t k = 0; k < 200; ++k) {
      for (const auto spot : {ShapingLattices::Spot::point, ShapingLattices::Spot::middle}) {
        const BaseColumn from{k * 77'777 - 9'000'000, k * k * 31'337 - 3'000'000};
        const auto at = lattices->column(i, from, spot);
        if (!at) continue;
        ++found;
        CAPTURE(lattices->names()[i], from.x, from.z, at->x, at->z);
        // A cell's diagonal, and the displacement.
        REQUIRE(std::abs(at->x - from.x) + std::abs(at->z - from.z) < 2 * noise.period + 1'000);
        const auto along = [&](const std::array<RotatedNoise, 2>& warp) {
          const double reach = static_cast<double>(slow.warp_reach[0] * rotated_fbm(warp[0], at->x, at->z)) +
                               static_cast<double>(slow.warp_reach[1] * rotated_fbm(warp[1], at->x, at->z));
          return static_cast<std::int64_t>(std::lrint(noises[i].displaced * reach));
        };
        const std::int64_t east = along(slow.warp_east);
        const std::int64_t south = along(slow.warp_south);
        const auto du = static_cast<std::int64_t>(lattice.du);
        const auto dv = static_cast<std::int64_t>(lattice.dv);
        const auto u = lattice.u(at->x, at->z) + static_cast<std::uint64_t>((du * east + dv * south) / 256);
        const auto v = lattice.v(at->x, at->z) + static_cast<std::uint64_t>((du * south - dv * east) / 256);
        const double half = spot == ShapingLattices::Spot::middle ? 0.5 : 0;
        CHECK(from_whole(cells(u) - half) < within);
        CHECK(from_whole(cells(v) - half) < within);
      }
    }
    CAPTURE(lattices->names()[i]);
    CHECK(found > 360);  // of 400: a displacement may leave a place out
  }
}

TEST_CASE("Land of other kinds than regions has neither parts nor lattices") {
  const auto world = World::parse(classic_world_toml(), "classic.toml");
  REQUIRE(world);
  CHECK(!LandPartsSampler::make(*world));
  CHECK(!ShapingLattices::make(*world));
}

}  // namespace
}  // namespace talus::terrain
