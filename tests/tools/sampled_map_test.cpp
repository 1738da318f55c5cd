#include "sampled_map.h"

#include <catch2/catch.hpp>

#include "world_with_looks.h"

using namespace talus;
using namespace talus::tools;

namespace {

Image sampled(const terrain::World& world, const map::ColumnGrid& grid,
              const SampledMapOptions& options = {}) {
  ProgressBar progress{"map", "columns"};
  return render_sampled_map(world, grid, options, progress);
}

void check_crop(const terrain::World& world, std::int64_t every) {
  INFO("every " << every);
  const map::ColumnGrid grid = map::grid_around(-12345, 6789, every, 60, 50);
  const Image whole = sampled(world, grid, {.threads = 1, .patch_edge = 64});
  CHECK(sampled(world, grid, {.threads = 3, .patch_edge = 17}).rgb == whole.rgb);
  const Image part = sampled(world, grid.part(11, 7, 20, 30));
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) REQUIRE(part.at(x, y) == whole.at(x + 11, y + 7));
  }
}

}  // namespace

TEST_CASE("A map from afar depends neither on threads nor on patches, and its parts join without a seam") {
  const terrain::World looks = test::world_with_looks();
  for (const std::int64_t every : {1, 3, 15, 16, 64, 4096}) check_crop(looks, every);
  for (const std::int64_t every : {3, 64, 200}) check_crop(terrain::default_world(), every);
}

TEST_CASE("From afar a column has the colour of its look, and the sea is darker where it is deep") {
  const terrain::World world = test::world_with_looks();
  const map::ColumnGrid grid = map::grid_around(0, 0, 300, 128, 128);
  const Image map = sampled(world, grid);
  const map::ColumnSamples samples = map::sample_columns(world, grid);
  double desert_red = 0;
  double meadow_red = 0;
  int deserts = 0;
  int meadows = 0;
  double shallow = 0;
  double deep = 0;
  int shallows = 0;
  int deeps = 0;
  for (int z = 0; z < grid.depth; ++z) {
    for (int x = 0; x < grid.width; ++x) {
      const std::int64_t over_sea = samples.heights_fx.at(x, z) - *world.sea_fx();
      const std::string& look = world.look_names()[samples.looks.at(x, z)];
      const terrain::Colour pixel = map.at(x, z);
      const double red = pixel.red - 0.5 * (pixel.green + pixel.blue);
      if (over_sea > 0 && look == "desert") desert_red += red, ++deserts;
      if (over_sea > 0 && look == "meadow") meadow_red += red, ++meadows;
      if (over_sea < -20 * 256 && over_sea > -30 * 256) shallow += pixel.green, ++shallows;
      if (over_sea < -50 * 256) deep += pixel.green, ++deeps;
    }
  }
  REQUIRE(std::min({deserts, meadows, shallows, deeps}) > 20);
  CHECK(desert_red / deserts > meadow_red / meadows + 20);
  CHECK(deep / deeps < shallow / shallows - 5);
}
