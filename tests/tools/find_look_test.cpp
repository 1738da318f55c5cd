#include "find_look.h"

#include <algorithm>
#include <numeric>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/map/column_grid.h>
#include "world_with_looks.h"

using namespace talus;
using namespace talus::tools;

namespace {

std::uint8_t number_of_look(const terrain::World& world, const std::string& name) {
  const auto& names = world.look_names();
  return static_cast<std::uint8_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::optional<FoundColumn> found(const terrain::World& world, const std::string& look, std::int64_t x,
                                 std::int64_t z, std::int64_t within) {
  ProgressBar progress{"find", "rings"};
  return find_look(world, number_of_look(world, look), x, z, within, progress);
}

std::int64_t square(std::int64_t x, std::int64_t z) {
  return x * x + z * z;
}

}  // namespace

TEST_CASE("The column found has the look, and within 256 columns no column is nearer") {
  const terrain::World world = test::world_with_looks();
  CHECK(rc::check([&] {
    const std::string look = *rc::gen::element<std::string>("desert", "meadow", "sea floor");
    const std::int64_t x = *rc::gen::inRange(-100000, 100000);
    const std::int64_t z = *rc::gen::inRange(-100000, 100000);
    const auto column = found(world, look, x, z, 40000);
    RC_PRE(column.has_value());
    const auto number = number_of_look(world, look);
    RC_ASSERT(map::sample_columns(world, {column->x, column->z, 1, 1, 1}).looks.values[0] == number);
    RC_ASSERT(std::max(std::abs(column->x - x), std::abs(column->z - z)) <= 40000);
    const map::ColumnGrid grid = map::grid_around(x, z, 1, 513, 513);
    const map::ColumnSamples all = map::sample_columns(world, grid);
    for (int k = 0; k < grid.depth; ++k) {
      for (int i = 0; i < grid.width; ++i) {
        if (all.looks.at(i, k) != number) continue;
        RC_ASSERT(square(grid.x_of(i) - x, grid.z_of(k) - z) >= square(column->x - x, column->z - z));
      }
    }
  }));
}

TEST_CASE("A look far away is found within reach, and not beyond it") {
  const terrain::World world = test::world_with_looks();
  const auto desert = found(world, "desert", 0, 0, 1 << 20);
  REQUIRE(desert);
  const std::int64_t away = std::max(std::abs(desert->x), std::abs(desert->z));
  CHECK(found(world, "desert", 0, 0, 1 << 20) == desert);
  CHECK(found(world, "desert", desert->x, desert->z, 1) == desert);
  CHECK_FALSE(found(world, "desert", 0, 0, away / 2));
  CHECK_FALSE(found(world, "nowhere", 0, 0, 1 << 16));
}

TEST_CASE("Shares of looks add up to everything") {
  const terrain::World world = test::world_with_looks();
  for (const std::int64_t within : {1, 100, 65536}) {
    const std::vector<double> shares = look_shares(world, 5, -5, within);
    CHECK(std::accumulate(shares.begin(), shares.end(), 0.0) == Approx(1));
    CHECK(shares[number_of_look(world, "nowhere")] == 0);
  }
}
