#include "map_picture.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "worlds.h"

using namespace talus;
using namespace talus::cli;
using namespace talus::cli::testing;

TEST_CASE("land without chunks is hatched in dark grey, next to the ground in its colour") {
  SurfaceMap surface{materials()};
  surface.add(key_at(0, 0, 0), flat(kGrass, 8, kAir));
  const Picture picture = draw_map(surface, materials(), {0, 0, 64, 32}, {});
  const glm::vec3 ground = picture.at(10, 10);
  CHECK(ground.g > 2 * ground.r);
  std::vector<float> greys;
  for (int x = 40; x < 56; ++x) {
    const glm::vec3 light = picture.at(x, 10);
    CHECK(std::max({light.r, light.g, light.b}) < 0.1F);
    greys.push_back(light.g);
  }
  const auto [darkest, lightest] = std::minmax_element(greys.begin(), greys.end());
  CHECK(*darkest < *lightest);
  // An edge around what is known.
  CHECK(picture.at(32, 10).g < *darkest);
  CHECK(picture.at(31, 10).g == Approx(ground.g).epsilon(0.2));
}

TEST_CASE("a path is a white line with a dark outline, on light ground too") {
  SurfaceMap surface{materials()};
  surface.add(key_at(0, 0, 0), flat(kStone, 8, kAir));
  const Picture plain = draw_map(surface, materials(), {0, 0, 32, 32}, {});
  const Picture picture = draw_map(surface, materials(), {0, 0, 32, 32}, {{4, 16}, {20, 16}});
  // Columns 15 and 16 lie beside the line; the next on either side are its outline.
  for (const int y : {15, 16}) CHECK(picture.at(8, y).g > 0.9F);
  for (const int y : {14, 17}) CHECK(picture.at(8, y).g < 0.6F * plain.at(8, y).g);
  for (const int y : {10, 21}) CHECK(picture.at(8, y).g == plain.at(8, y).g);
}

TEST_CASE("water has the world's colour for it, darker where it is deep") {
  const auto pixel = [](int bed, int surface) {
    SurfaceMap map{materials()};
    map.add(key_at(0, 0, 0), layered(kStone, bed, kWater, surface));
    return draw_map(map, materials(), {0, 0, 32, 32}, {}).at(16, 16);
  };
  const glm::vec3 colour = to_light(0x204080);  // of kWater in worlds.h
  const glm::vec3 shallow = pixel(20, 24);
  const glm::vec3 deep = pixel(2, 30);
  CHECK(shallow.b > 2 * shallow.r);
  CHECK(deep.b < shallow.b);
  for (int channel = 0; channel < 3; ++channel) CHECK(deep[channel] < colour[channel]);
  CHECK(deep.b / deep.g == Approx(colour.b / colour.g).epsilon(0.05));
}
