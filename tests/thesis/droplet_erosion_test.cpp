#include "droplet_erosion.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include <talus/world_files/world_files.h>

#include "erode_height_map.h"
#include "height_map_file.h"
#include "scratch_directory.h"

using namespace talus;
using namespace talus::tools;

namespace {

// A cone with some roughness, from which the same seed takes the same.
HeightGrid cone(int width, int depth) {
  HeightGrid grid{width, depth, {}};
  for (int z = 0; z < depth; ++z) {
    for (int x = 0; x < width; ++x) {
      const double distance = std::hypot(x - width / 2, z - depth / 2);
      grid.heights.push_back(100 - distance + (x * 7 + z * 13) % 5 * 0.3);
    }
  }
  return grid;
}

void eroded(HeightGrid& grid, std::uint64_t droplets, std::uint64_t seed) {
  ProgressBar progress{"erode-heightmap", "droplets"};
  erode(grid, {droplets, seed}, progress);
}

double sum_of(const HeightGrid& grid) {
  return std::accumulate(grid.heights.begin(), grid.heights.end(), 0.0);
}

}  // namespace

TEST_CASE("Droplets carry ground away and create no ground") {
  CHECK(rc::check([] {
    HeightGrid grid = cone(*rc::gen::inRange(2, 60), *rc::gen::inRange(2, 60));
    const HeightGrid before = grid;
    eroded(grid, static_cast<std::uint64_t>(*rc::gen::inRange(0, 500)), *rc::gen::arbitrary<std::uint64_t>());
    RC_ASSERT(sum_of(grid) <= sum_of(before) * (1 + 1e-12));
    for (const double height : grid.heights) RC_ASSERT(std::isfinite(height));
    RC_ASSERT(*std::min_element(grid.heights.begin(), grid.heights.end()) >=
              *std::min_element(before.heights.begin(), before.heights.end()) - 1e-9);
  }));
}

TEST_CASE("The seed decides where droplets fall, and nothing else does") {
  HeightGrid first = cone(70, 50);
  HeightGrid second = cone(70, 50);
  HeightGrid other = cone(70, 50);
  eroded(first, 2000, 9);
  eroded(second, 2000, 9);
  eroded(other, 2000, 10);
  CHECK(first.heights == second.heights);
  CHECK(first.heights != other.heights);
  CHECK(first.heights != cone(70, 50).heights);
}

TEST_CASE("The unit of the heights does not matter") {
  HeightGrid small = cone(40, 40);
  HeightGrid large = cone(40, 40);
  for (double& height : large.heights) height *= 1024;  // exactly
  eroded(small, 1000, 3);
  eroded(large, 1000, 3);
  for (std::size_t i = 0; i < small.heights.size(); ++i) {
    CHECK(large.heights[i] == Approx(small.heights[i] * 1024).epsilon(1e-9));
  }
}

TEST_CASE("Level ground stays as it is") {
  HeightGrid grid{9, 9, std::vector<double>(81, 5.0)};
  eroded(grid, 100, 1);
  CHECK(grid.heights == std::vector<double>(81, 5.0));
}

TEST_CASE("Height maps come back from their files to the number") {
  const ScratchDirectory scratch;
  const terrain::HeightMap words{3, 2, std::vector<std::uint16_t>{0, 1, 2, 32768, 65534, 65535}};
  const terrain::HeightMap real{2, 2, std::vector<float>{-1.5F, 0, 3e9F, 1e-9F}};
  for (const char* name : {"a.png", "a.npy"}) {
    REQUIRE(write_height_map(scratch / name, words));
    const auto back = world_files::read_height_map(scratch / name);
    REQUIRE(back);
    CHECK(back->width == 3);
    CHECK(back->depth == 2);
    CHECK(back->samples == words.samples);
  }
  REQUIRE(write_height_map(scratch / "b.npy", real));
  CHECK(world_files::read_height_map(scratch / "b.npy")->samples == real.samples);
  CHECK(write_height_map(scratch / "b.png", real).error().exit_code == kExitWrongUse);
  CHECK(write_height_map(scratch / "b.tif", real).error().exit_code == kExitWrongUse);
}

TEST_CASE("An eroded file is a height map like any other, with the type of its input") {
  const ScratchDirectory scratch;
  terrain::HeightMap map{40, 30, std::vector<std::uint16_t>{}};
  for (const double height : cone(40, 30).heights) {
    std::get<0>(map.samples).push_back(static_cast<std::uint16_t>(height * 600));
  }
  REQUIRE(write_height_map(scratch / "in.png", map));
  REQUIRE(erode_height_map(scratch / "in.png", scratch / "out.png", {5000, 1}));
  REQUIRE(erode_height_map(scratch / "in.png", scratch / "again.png", {5000, 1}));
  const auto out = world_files::read_height_map(scratch / "out.png");
  REQUIRE(out);
  CHECK(out->width == 40);
  CHECK(std::holds_alternative<std::vector<std::uint16_t>>(out->samples));
  CHECK(out->samples != map.samples);
  CHECK(read_whole(scratch / "out.png") == read_whole(scratch / "again.png"));
}
