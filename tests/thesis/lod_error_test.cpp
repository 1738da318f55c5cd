#include "lod_error.h"

#include <algorithm>
#include <cmath>

#include <talus/terrain/extraction.h>
#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::tools;

namespace {

LodError measured(const terrain::Region& region, int threads = 1) {
  ProgressBar progress{"lod-error", "columns"};
  return measure_lod_error(terrain::default_world(), region, threads, progress);
}

// The row of the first free voxel over the highest solid one, from the chunks themselves.
std::int64_t ground_row(const terrain::World& world, std::int64_t x, std::int64_t z, Lod lod) {
  for (std::int64_t y = (height_range(world).high >> lod.value()) + 1;; --y) {
    const auto key = chunk_holding(VoxelPos{x, y, z}, lod);
    const MaterialId material = generate_chunk(world, *key).at(local_pos({x, y, z}));
    if (material != kAir && material != kWater) return y + 1;
  }
}

}  // namespace

TEST_CASE("Errors of the levels match their chunks' voxels") {
  const terrain::World& world = terrain::default_world();
  const terrain::Region region{-64, 640, 64, 64, Lod{}};
  const LodError error = measured(region);
  REQUIRE(error.rows.size() == 6);
  // Level 6 has one column here.
  const std::int64_t coarse = ground_row(world, -1, 10, Lod::of(6)) << 6;
  std::int64_t most = 0;
  for (const int x : {0, 31, 63}) {
    for (const int z : {0, 32, 63}) {
      most = std::max(most, std::abs(coarse - ground_row(world, region.x + x, region.z + z, Lod{})));
    }
  }
  CHECK(error.rows[5].level == 6);
  CHECK(error.rows[5].max_voxels >= static_cast<double>(most));
  CHECK(error.rows[5].mean_voxels <= error.rows[5].max_voxels);
}

TEST_CASE("A coarse level shows water where level 0 does, though its ground rounds up to the sea's row") {
  const terrain::Region bay{12992, 8960, 64, 64, Lod{}};  // of the sea, 25 voxels deep
  const std::int64_t x = bay.x >> 6;
  const std::int64_t z = bay.z >> 6;
  constexpr std::int64_t kSeaRow = 2;  // of level 6
  const auto at = [&](std::int64_t row) {
    const VoxelPos voxel{x, row, z};
    const Lod lod = Lod::of(6);
    return generate_chunk(terrain::default_world(), *chunk_holding(voxel, lod)).at(local_pos(voxel));
  };
  REQUIRE(at(kSeaRow - 1) == kWater);
  REQUIRE(at(kSeaRow) == kAir);
  REQUIRE(at(kSeaRow - 2) != kWater);  // the ground would reach the sea's row
  const LodError error = measured(bay);
  CHECK(error.rows[5].same_material == 1);
}

TEST_CASE("Coarser levels lie further off") {
  const LodError error = measured({-256, -256, 512, 512, Lod{}});
  for (std::size_t i = 1; i < error.rows.size(); ++i) {
    CHECK(error.rows[i].mean_surface > error.rows[i - 1].mean_surface);
    CHECK(error.rows[i].same_material <= error.rows[i - 1].same_material);
  }
  CHECK(error.rows[0].mean_surface < 1);
  CHECK(error.rows[0].same_material > 0.5);
  for (const LodErrorRow& row : error.rows) {
    CAPTURE(row.level);
    CHECK((row.skyline > 0 && row.skyline < 4));
    CHECK(row.same_elsewhere >= row.same_material);
  }
}

TEST_CASE("Errors of the levels do not depend on threads") {
  const terrain::Region region{0, 0, 1024, 1024, Lod{}};
  CHECK(to_json(measured(region, 1)) == to_json(measured(region, 3)));
}
