#include "isometric.h"

#include <vector>

#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::tools;

namespace {

const std::vector<glm::vec3> kLights{{0, 0, 0}, {0.1F, 0.2F, 0.6F}, {0.5F, 0.1F, 0.1F}};
constexpr MaterialId kRed{2};

Image picture_of(const VoxelGrid& grid, int threads = 1) {
  ProgressBar progress{"picture", "rows"};
  return render_isometric(grid, kLights, {.width = 120, .height = 100, .threads = threads}, progress);
}

int brightness(terrain::Colour colour) {
  return colour.red + colour.green + colour.blue;
}

// The brightest of a block's sides is its top, then comes the south on the left, then the east on the right.
struct Sides {
  terrain::Colour top;
  terrain::Colour south;
  terrain::Colour east;
};
Sides sides_of(const Image& image) {
  return {image.at(60, 30), image.at(40, 65), image.at(80, 65)};
}

VoxelGrid block() {
  VoxelGrid grid{8, 8, 8};
  for (int z = 0; z < 8; ++z) {
    for (int x = 0; x < 8; ++x) grid.fill(x, z, 0, 8, kRed);
  }
  return grid;
}

}  // namespace

TEST_CASE("A block shows three sides of different brightness in its material's colour") {
  const Sides sides = sides_of(picture_of(block()));
  CHECK(brightness(sides.top) > brightness(sides.south) + 30);
  CHECK(brightness(sides.south) > brightness(sides.east) + 30);
  for (const terrain::Colour colour : {sides.top, sides.south, sides.east}) {
    CHECK(colour.red > colour.green + 40);
    CHECK(colour.red > colour.blue + 40);
  }
}

TEST_CASE("The east is on the right") {
  VoxelGrid grid = block();
  for (int z = 0; z < 8; ++z) grid.fill(7, z, 0, 8, MaterialId{1});
  const Sides sides = sides_of(picture_of(grid));
  CHECK(sides.east.blue > sides.east.red);
  CHECK(sides.south.red > sides.south.blue);
}

TEST_CASE("A picture does not depend on threads") {
  CHECK(picture_of(block(), 1).rgb == picture_of(block(), 3).rgb);
}

TEST_CASE("A tower throws its shadow to the east, which is to the right") {
  VoxelGrid flat{16, 12, 16};
  for (int z = 0; z < 16; ++z) {
    for (int x = 0; x < 16; ++x) flat.fill(x, z, 0, 2, kRed);
  }
  VoxelGrid tower = flat;
  tower.fill(4, 10, 2, 12, kRed);
  const Image before = picture_of(flat);
  const Image after = picture_of(tower);
  int darker_right = 0;
  int darker_left = 0;
  // The tower itself stands between.
  constexpr int kTowerLeft = 32;
  constexpr int kTowerRight = 48;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 120; ++x) {
      if (brightness(after.at(x, y)) + 40 >= brightness(before.at(x, y))) continue;
      darker_right += x > kTowerRight ? 1 : 0;
      darker_left += x < kTowerLeft ? 1 : 0;
    }
  }
  CHECK(darker_right > 50);
  CHECK(darker_left == 0);
}

TEST_CASE("Shallow water lets its bed shine through, deep water does not") {
  const auto pond = [](int deep) {
    VoxelGrid grid{8, 40, 8};
    for (int z = 0; z < 8; ++z) {
      for (int x = 0; x < 8; ++x) {
        grid.fill(x, z, 0, 40 - deep, kRed);
        grid.fill(x, z, 40 - deep, 40, kWater);
      }
    }
    return picture_of(grid).at(60, 14);
  };
  CHECK(pond(1).red > pond(20).red + 30);
  CHECK(pond(20).blue > pond(20).red + 60);
}
