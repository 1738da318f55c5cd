#include <talus/map/column_grid.h>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/terrain/heights.h>

#include "world_with_looks.h"

using namespace talus;
using namespace talus::map;

TEST_CASE("A grid's samples equal its columns' samples") {
  const terrain::World world = test::world_with_looks();
  const std::vector<std::string> names{"temperature", "height"};
  CHECK(rc::check([&] {
    const std::int64_t every = *rc::gen::inRange<std::int64_t>(1, 5000);
    const std::int64_t far = std::int64_t{1} << 30;
    const std::int64_t x = *rc::gen::inRange(-far, far);
    const std::int64_t z = *rc::gen::inRange(-far, far);
    const ColumnGrid grid = grid_around(x, z, every, 9, 7);
    const ColumnSamples all = sample_columns(world, grid, names);
    const int i = *rc::gen::inRange(0, 9);
    const int k = *rc::gen::inRange(0, 7);
    const ColumnSamples one = sample_columns(world, {grid.x_of(i), grid.z_of(k), 1, 1, 1}, names);
    const auto place = static_cast<std::size_t>(k * 9 + i);
    RC_ASSERT(all.heights_fx.at(i, k) == one.heights_fx.values[0]);
    RC_ASSERT(all.looks.at(i, k) == one.looks.values[0]);
    for (std::size_t n = 0; n < names.size(); ++n) RC_ASSERT(all.values[n][place] == one.values[n][0]);
    const terrain::BaseColumn column{grid.x_of(i), grid.z_of(k)};
    RC_ASSERT(all.heights_fx.at(i, k) == terrain::surface_heights(world, {&column, 1}).front());
  }));
}

TEST_CASE("A grid past the world's end repeats the last columns") {
  const terrain::World world = test::world_with_looks();
  const std::int64_t end = std::int64_t{1} << 36;
  const ColumnSamples samples = sample_columns(world, {end - 2, -end - 1, 1, 4, 2});
  CHECK(samples.heights_fx.at(1, 0) == samples.heights_fx.at(3, 0));
  CHECK(samples.heights_fx.at(0, 0) == samples.heights_fx.at(0, 1));
}

TEST_CASE("Provinces are not looks") {
  std::string text = test::text_of_world_with_looks();
  text.resize(text.find("[[look]]"));
  text +=
      "[[stratified]]\nname = \"chalk\"\ncolour = \"#eeeeee\"\ndepth = 100\nthickness = 50\nroughness = 0.1\n"
      "[[province]]\nname = \"red\"\nabove = { height = -1000 }\ncolours = { chalk = \"#ff0000\" }\n";
  const auto world = terrain::World::parse(text, "provinces.toml");
  INFO((world ? "" : world.error().message));
  REQUIRE(world);
  const ColumnSamples samples = sample_columns(*world, {0, 0, 100, 20, 20});
  CHECK(std::all_of(samples.looks.values.begin(), samples.looks.values.end(),
                    [](auto look) { return look == 0; }));
}
