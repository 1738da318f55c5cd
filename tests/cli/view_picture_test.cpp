#include "view_picture.h"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "worlds.h"

using namespace talus;
using namespace talus::cli;
using namespace talus::cli::testing;

namespace {

constexpr int kWidth = 24;
constexpr int kHeight = 16;

/// A plain of 7 x 7 chunks, seen from above its middle.
Picture plain(MaterialId ground, int& rows_drawn) {
  client::ChunkStore store{64 << 20};
  for (int z = -3; z <= 3; ++z) {
    for (int x = -3; x <= 3; ++x) store.put(received(key_at(x, 0, z), flat(ground, 8, kAir)));
  }
  const Camera camera{{16, 20, 16}, glm::normalize(glm::dvec3{1, -0.1, 0.2}), 62};
  rows_drawn = 0;
  return draw_view(store, materials(), camera, 100, kWidth, kHeight, [&](int rows) { rows_drawn += rows; });
}

float brightness(const glm::vec3& light) {
  return light.r + light.g + light.b;
}

}  // namespace

TEST_CASE("below the horizon lies the ground in its colour, above it the sky") {
  int rows = 0;
  const Picture picture = plain(kGrass, rows);
  REQUIRE(picture.width == kWidth);
  const glm::vec3 ground = picture.at(kWidth / 2, kHeight - 1);
  const glm::vec3 sky = picture.at(kWidth / 2, 0);
  CHECK(ground.g > ground.r);
  CHECK(ground.g > ground.b);
  CHECK(sky.b > sky.r);
}

TEST_CASE("a material beyond the land's own has its colour, too") {
  int rows = 0;
  const glm::vec3 ground = plain(kRedWool, rows).at(kWidth / 2, kHeight - 1);
  CHECK(ground.r > 2 * ground.g);
  CHECK(ground.r > 2 * ground.b);
  CHECK(ground.r > 0.1F);
}

TEST_CASE("a picture is the same each time, on two threads") {
  int rows = 0;
  const Picture first = plain(kStone, rows);
  const Picture second = plain(kStone, rows);
  CHECK(first.pixels == second.pixels);
}

TEST_CASE("pixels are light from 0 to 1, and not all are the same") {
  int rows = 0;
  const Picture picture = plain(kWater, rows);
  for (const glm::vec3& pixel : picture.pixels) {
    for (int channel = 0; channel < 3; ++channel) {
      CHECK(pixel[channel] >= 0.0F);
      CHECK(pixel[channel] <= 1.0F);
    }
  }
  CHECK(brightness(picture.at(0, 0)) != brightness(picture.at(0, kHeight - 1)));
}

TEST_CASE("water is turquoise over its bed, and what stands on its bank is a dark tone in its mirror") {
  client::ChunkStore store{64 << 20};
  for (int z = -3; z <= 3; ++z) {
    for (int x = -3; x <= 3; ++x) {
      if (x == 2) {
        store.put(received(key_at(x, 0, z), flat(kRedWool, 31, kAir)));
      } else {
        store.put(received(key_at(x, 0, z), layered(kStone, 4, kWater, 16)));
      }
    }
  }
  const auto middle = [&](const glm::dvec3& direction) {
    const Camera camera{{16, 24, 16}, glm::normalize(direction), 30};
    return draw_view(store, materials(), camera, 300, 9, 9, [](int) {}).at(4, 4);
  };
  const glm::vec3 wall = middle({1, 0.02, 0});
  REQUIRE(wall.r > 2 * wall.g);
  const glm::vec3 steep = middle({1, -2, 0});
  CHECK(steep.g > 1.3F * steep.r);
  CHECK(steep.b > 1.3F * steep.r);
  // Down onto the surface, from where a mirror sends the ray into the wall.
  const glm::vec3 mirror = middle({1, -0.2, 0});
  CHECK(mirror.b > mirror.r);
  CHECK(mirror.r < 1.5F * mirror.g);
}

TEST_CASE("every row is reported once") {
  int rows = 0;
  (void)plain(kStone, rows);
  CHECK(rows == kHeight);
}
