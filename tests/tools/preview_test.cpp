#include "preview.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/voxel/codec.h>
#include <catch2/catch.hpp>

#include <talus/map/column_grid.h>
#include "preview_numbers.h"
#include "profile.h"
#include "section.h"
#include "world_with_looks.h"

#include "worlds.h"

using namespace talus;
using namespace talus::tools;

namespace {

double sum_of(const std::vector<NamedShare>& shares) {
  double sum = 0;
  for (const NamedShare& one : shares) sum += one.share;
  return sum;
}

}  // namespace

TEST_CASE("A sheet is drawn of every kind of world, as wide for all") {
  const terrain::World looks = test::world_with_looks();
  const auto with_fields = draw_preview(looks, "looks_world", -300, 40, {.threads = 2});
  REQUIRE(with_fields);
  const auto without = draw_preview(terrain::default_world(), "default", 0, 0, {});
  REQUIRE(without);
  CHECK(with_fields->width == without->width);
  CHECK(with_fields->height > 1400);
  CHECK(with_fields->rgb.size() == std::size_t{3} * static_cast<std::size_t>(with_fields->width) *
                                       static_cast<std::size_t>(with_fields->height));
}

TEST_CASE("A sheet is refused where its largest map leaves the world") {
  const terrain::World world = test::world_with_looks();
  const auto sheet = draw_preview(world, "looks", (std::int64_t{1} << 36) - 1000, 0, {});
  REQUIRE_FALSE(sheet);
  CHECK(sheet.error().exit_code == kExitWrongUse);
  CHECK_THAT(sheet.error().message, Catch::StartsWith("--center: column x = "));
}

TEST_CASE("Shares of land and of what is seen add up, whatever the threads") {
  const terrain::World world = test::world_with_looks();
  const map::ColumnGrid grid = map::grid_around(100, 200, 64, 100, 90);
  ProgressBar progress{"land", "columns"};
  const LandNumbers land = measure_land(world, grid, 1, progress);
  CHECK(sum_of(land.looks) == Approx(1));
  CHECK(std::accumulate(land.heights.begin(), land.heights.end(), 0.0) == Approx(1));
  CHECK(land.deepest.voxels < land.highest.voxels);
  CHECK(land.water > 0);
  CHECK(land.water < 1);
  CHECK(land.steep[0] >= land.steep[2]);
  const LandNumbers again = measure_land(world, grid, 3, progress);
  CHECK(again.water == land.water);
  CHECK(again.highest.x == land.highest.x);
  CHECK(again.steep == land.steep);

  const auto tops = materials_on_top(world, {-150, -90, 300, 280, Lod::of(3)}, 2, progress);
  CHECK(sum_of(tops) == Approx(1));
  for (std::size_t i = 1; i < tops.size(); ++i) CHECK(tops[i].share <= tops[i - 1].share);
}

TEST_CASE("Bytes of chunks are the same each time; only seconds differ") {
  const terrain::World world = test::world_with_looks();
  ProgressBar progress{"cost", "squares"};
  const CostNumbers cost = measure_cost(world, map::grid_around(0, 0, 8, 100, 100), progress);
  CHECK(cost.ns_a_column > 0);
  CHECK(cost.ns_a_chunk > 0);
  CHECK(cost.chunks_a_column >= 1);
  CHECK(cost.bytes_a_chunk <= static_cast<double>(cost.max_bytes));
  const CostNumbers again = measure_cost(world, map::grid_around(0, 0, 8, 100, 100), progress);
  CHECK(again.bytes_a_chunk == cost.bytes_a_chunk);
  CHECK(again.max_bytes == cost.max_bytes);
}

TEST_CASE("The cost of chunks covers only mixed ones") {
  // Caves and objects widen the range of rows in which chunks may be mixed.
  const terrain::World& world = terrain::default_world();
  const map::ColumnGrid grid = map::grid_around(-2496, -2240, 8, 616, 616);
  ProgressBar progress{"cost", "squares"};
  const CostNumbers cost = measure_cost(world, grid, progress);
  std::int64_t mixed = 0;
  std::int64_t bytes = 0;
  for (int square = 0; square < 16; ++square) {
    const auto chunk_at = [&](std::int64_t first, int index) {
      const std::int64_t apart = grid.every * 616 / 4;
      return static_cast<std::int32_t>(floor_div(first + apart * index + apart / 2, kChunkSize));
    };
    for (int chunk = 0; chunk < 16; ++chunk) {
      const std::int32_t x = chunk_at(grid.x, square % 4) + chunk % 4;
      const std::int32_t z = chunk_at(grid.z, square / 4) + chunk / 4;
      const terrain::MixedRange rows = mixed_range(world, Lod{});
      for (std::int32_t y = rows.first; y <= rows.last; ++y) {
        const Chunk one = generate_chunk(world, {{x, y, z}, Lod{}});
        if (one.is_uniform()) continue;
        std::vector<std::byte> payload;
        encode(one, payload);
        ++mixed;
        bytes += static_cast<std::int64_t>(payload.size());
      }
    }
  }
  REQUIRE(mixed > 256);
  CHECK(cost.bytes_a_chunk == Approx(static_cast<double>(bytes) / static_cast<double>(mixed)));
  CHECK(cost.chunks_a_column == Approx(static_cast<double>(mixed) / 256));
}

TEST_CASE("No column is higher than a sheet says is possible") {
  for (const terrain::World& world : {test::world_with_looks(), test::sample_world("classic")}) {
    ProgressBar progress{"land", "columns"};
    const LandNumbers land = measure_land(world, map::grid_around(0, 0, 640, 200, 200), 2, progress);
    CHECK(land.highest.voxels <= land.highest_possible);
    CHECK(land.highest_possible < 20 * land.highest.voxels);
  }
}

TEST_CASE("At level 0 a profile shows what a section shows") {
  // Caves, ores and objects are left out of profiles.
  const terrain::World& world = test::sample_world("classic");
  const terrain::Region line{-100, 33, 200, 1, Lod{}};
  ProgressBar progress{"section", "columns"};
  const auto section = render_section(world, line, {}, progress);
  REQUIRE(section);
  constexpr int kUnderZero = 8;
  const Image profile =
      render_profile(world, line, {.low = -kUnderZero, .rows = section->height, .step = 1}, 2, progress);
  CHECK(profile.rgb == section->rgb);
  // Every third row.
  const Image squeezed =
      render_profile(world, line, {.low = -kUnderZero, .rows = 20, .step = 3}, 1, progress);
  for (int x = 0; x < line.width; ++x) {
    CHECK(squeezed.at(x, 19) == section->at(x, section->height - 1));
    if (section->at(x, section->height - 13) == world.materials()[2].colour) {
      CHECK(squeezed.at(x, 15) == world.materials()[2].colour);
    }
  }
}
