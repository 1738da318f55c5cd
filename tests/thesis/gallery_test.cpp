#include <filesystem>
#include <set>
#include <string>

#include <talus/terrain/heights.h>
#include <catch2/catch.hpp>

#include "gallery.h"
#include "gallery_figures.h"
#include "gallery_place.h"
#include "scratch_directory.h"

using namespace talus;
using namespace talus::tools;

namespace {

const terrain::World& classic_world() {
  static const auto world = terrain::World::parse(terrain::classic_world_toml(), "classic.toml").value();
  return world;
}

Image draw(const Figure& figure, int threads) {
  const WorldText text{std::string{terrain::classic_world_toml()}, "here.toml"};
  ProgressBar progress{"gallery", "rows"};
  auto image = figure.draw({text, classic_world(), threads, progress});
  REQUIRE(image);
  return std::move(*image);
}

}  // namespace

TEST_CASE("Every figure has a file of its own") {
  std::set<std::string> files;
  for (const Figure& figure : gallery_figures()) CHECK(files.insert(figure.file).second);
}

TEST_CASE("A figure of the same world is the same picture, whatever the threads") {
  for (const Figure& figure : gallery_figures()) {
    if (std::string{figure.file} != "gallery-13-settling.png") continue;
    CHECK(draw(figure, 1).rgb == draw(figure, 2).rgb);
  }
}

TEST_CASE("A place is the same ground at every resolution") {
  const Place place{-1.5, 2.25, 2};
  const terrain::Region columns = columns_of(place, classic_world());
  CHECK(columns == terrain::Region{-300, 450, 400, 400, Lod{}});
}

TEST_CASE("A scenic place has high ground at the back and low ground in front") {
  const terrain::World& world = classic_world();
  const Place place = scenic_place(world, 1);
  const terrain::Region columns = columns_of(place, world);
  const auto height = [&](int x, int z) {
    const terrain::BaseColumn column{columns.x + x, columns.z + z};
    return surface_heights(world, {&column, 1}).front();
  };
  CHECK(height(40, 40) > 2 * height(160, 160));
}

TEST_CASE("A figure that is not there is named, and nothing is made") {
  const WorldText text{std::string{terrain::classic_world_toml()}, "here.toml"};
  ProgressBar progress{"gallery", "rows"};
  const ScratchDirectory scratch;
  const auto written = write_gallery(text, "no such", scratch / "gallery", 1, progress);
  REQUIRE_FALSE(written);
  CHECK_THAT(written.error().message, Catch::Contains("--only no such"));
  CHECK_FALSE(std::filesystem::exists(scratch / "gallery"));
}
