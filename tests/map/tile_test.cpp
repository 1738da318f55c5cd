// Tiles of the map: no seam between neighbours, pieces that do not show, one light at all zooms.
#include <talus/map/tile_painting.h>

#include <catch2/catch.hpp>
#include <cmath>

#include <talus/map/light.h>
#include <talus/voxel/coords.h>

#include "world_with_looks.h"

using namespace talus;
using namespace talus::map;

namespace {

Image drawn(const terrain::World& world, const Tile& tile) {
  TilePainting painting{world, tile};
  while (painting.step()) {
  }
  return painting.take();
}

terrain::World classic() {
  return *terrain::World::parse(terrain::classic_world_toml(), "classic.toml");
}

/// One picture of `across` x `down` tiles, drawn at once.
Image drawn_at_once(const terrain::World& world, const Tile& first, int across, int down) {
  Image image{across * kTilePixels, down * kTilePixels};
  const std::int64_t every = first.columns_a_pixel();
  const std::int64_t x = first.x * kTilePixels;
  const std::int64_t z = first.z * kTilePixels;
  const auto paint = [&](Painting& painting) {
    while (painting.step()) {
    }
  };
  if (first.zoom >= 6) {
    const Lod lod = Lod::of(kMaxZoom - first.zoom);
    const RegionPainter painter{world, lod, exaggeration(static_cast<float>(every))};
    terrain::Generator generator{world};
    paint(*painter.start(generator, {x, z, image.width, image.height, lod}, image, 0, 0));
  } else {
    const GridPainter painter{world, every, GridColours::told_by_slope};
    paint(*painter.start({x * every, z * every, every, image.width, image.height}, image, 0, 0));
  }
  return image;
}

void check_joined(const terrain::World& world, const Tile& first) {
  INFO("zoom " << first.zoom);
  const Image whole = drawn_at_once(world, first, 2, 1);
  for (int tile = 0; tile < 2; ++tile) {
    const Image one = drawn(world, {first.zoom, first.x + tile, first.z});
    for (int y = 0; y < kTilePixels; ++y) {
      for (int x = 0; x < kTilePixels; ++x) REQUIRE(one.at(x, y) == whole.at(tile * kTilePixels + x, y));
    }
  }
}

double mean_light(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const glm::vec3 light = to_light(image.at(x, y));
      sum += 0.2126 * light.x + 0.7152 * light.y + 0.0722 * light.z;
    }
  }
  return sum / (static_cast<double>(image.width) * image.height);
}

}  // namespace

TEST_CASE("Neighbouring tiles are one picture, near and far, also where x and z are negative") {
  const terrain::World looks = test::world_with_looks();
  const terrain::World plain = classic();
  for (const int zoom : {12, 9, 6, 5, 0}) {
    check_joined(looks, {zoom, -1, -2});
    check_joined(plain, {zoom, -1, 3});
  }
}

TEST_CASE("Tiles at the edge of the world are drawn") {
  const std::int64_t limit = std::int64_t{1} << 16;
  for (const std::int64_t x : {-limit, limit - 1}) {
    const auto tile = checked_tile(0, x, x);
    REQUIRE(tile);
    CHECK(mean_light(drawn(terrain::default_world(), *tile)) > 0);
  }
  CHECK_FALSE(checked_tile(0, limit, 0));
  CHECK_FALSE(checked_tile(0, 0, -limit - 1));
  CHECK(checked_tile(12, (std::int64_t{1} << 28) - 1, 0));
  CHECK_FALSE(checked_tile(12, std::int64_t{1} << 28, 0));
  CHECK_FALSE(checked_tile(13, 0, 0));
  CHECK_FALSE(checked_tile(-1, 0, 0));
  CHECK_THAT(checked_tile(11, INT64_MIN, 0).error(), Catch::Contains("at zoom 11"));
}

TEST_CASE("The same land is as bright at one zoom as at the next, sampled or generated") {
  for (const terrain::World& world : {terrain::default_world(), classic()}) {
    double before = 0;
    for (int zoom = 4; zoom <= 6; ++zoom) {
      const std::int64_t edge = std::int64_t{1} << (zoom - 4);  // tiles of the land of one at zoom 4
      double light = 0;
      for (std::int64_t z = 0; z < edge; ++z) {
        for (std::int64_t x = 0; x < edge; ++x) light += mean_light(drawn(world, {zoom, edge + x, z}));
      }
      light /= static_cast<double>(edge * edge);
      INFO("zoom " << zoom << ": " << light << " after " << before);
      if (before > 0) CHECK(std::abs(light / before - 1) < 0.1);
      before = light;
    }
  }
}

TEST_CASE("Water is darker where it is deep") {
  const Image map = drawn(terrain::default_world(), {8, -1, -1});
  const ColumnSamples samples =
      sample_columns(terrain::default_world(), {-256 * 16, -256 * 16, 16, 256, 256});
  const std::int32_t sea_fx = *terrain::default_world().sea_fx();
  double shallow = 0;
  double deep = 0;
  int shallows = 0;
  int deeps = 0;
  for (int z = 0; z < 256; ++z) {
    for (int x = 0; x < 256; ++x) {
      const std::int32_t depth_fx = sea_fx - samples.heights_fx.at(x, z);
      const terrain::Colour pixel = map.at(x, z);
      if (depth_fx > 4 * 256 && depth_fx < 12 * 256) shallow += pixel.green, ++shallows;
      if (depth_fx > 40 * 256) deep += pixel.green, ++deeps;
    }
  }
  REQUIRE(std::min(shallows, deeps) > 100);
  CHECK(deep / deeps < shallow / shallows - 10);
}
