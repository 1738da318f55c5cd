#include "quality.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "world_with_looks.h"

using namespace talus;
using namespace talus::tools;

namespace {

Quality measured(const terrain::World& world, int threads) {
  ProgressBar progress{"quality", "columns"};
  return measure_quality(world,
                         {.threads = threads,
                          .spectra = 3,
                          .blocks = 12,
                          .windows = 3,
                          .window_side = 128,
                          .lattice_places = 700},
                         progress);
}

}  // namespace

TEST_CASE("A world's figures do not depend on threads") {
  const terrain::World world = test::world_with_looks();
  Quality one = measured(world, 1);
  Quality three = measured(world, 3);
  CHECK(to_text(one) == to_text(three));
  CHECK(to_json(one) == to_json(three));
}

TEST_CASE("Figures of a world agree with each other and with its bounds") {
  const terrain::World world = test::world_with_looks();
  const Quality quality = measured(world, 2);
  REQUIRE(quality.bands.size() == 6);
  for (const QualityBand& band : quality.bands) {
    CHECK(band.power.ratio > 0.3);
    CHECK(band.power.ratio < 3);
    CHECK(band.power.error > 0);
  }
  int blocks = 0;
  double share = 0;
  double water = 0;
  for (const QualityKind& kind : quality.kinds) {
    blocks += kind.blocks;
    share += kind.share;
    if (!kind.ground) water = kind.share;
    CHECK(kind.name != "nowhere");
  }
  CHECK(blocks == 12);
  CHECK(share == Approx(1));
  CHECK(water == Approx(quality.water_mean));
  CHECK(quality.steep[0] >= quality.steep[1]);
  CHECK(quality.steep[1] >= quality.steep[2]);
  CHECK(quality.highest.voxels <= (world.highest_fx() - *world.sea_fx()) / 256.0);
  CHECK(quality.highest.voxels > quality.deepest.voxels);
  CHECK(quality.largest_step.voxels >= quality.other_step.voxels);
  CHECK(quality.lattices.size() == 6);
  for (const QualityLattice& lattice : quality.lattices) {
    CAPTURE(lattice.noise);
    // The error of 700 independent places; those near each other are not.
    CHECK(lattice.error == Approx(std::sqrt(2.0 / 700)).epsilon(0.1));
    CHECK(lattice.apart < 4 * lattice.error);
    CHECK(lattice.at_points > quality.deepest.voxels);
    CHECK(lattice.at_points < quality.highest.voxels);
  }
  CHECK(quality.wishes.size() == 7);
}

TEST_CASE("A world of another kind has no figures of regions") {
  const auto world = terrain::World::parse(terrain::classic_world_toml(), "classic.toml");
  REQUIRE(world);
  const Quality quality = measured(*world, 2);
  CHECK(quality.lattices.empty());
  CHECK(quality.wishes.size() == 5);
  CHECK_THAT(to_text(quality), !Catch::Contains("Lattices"));
}

TEST_CASE("A requirement that a world does not meet is reported") {
  const terrain::World world = test::world_with_looks();
  const auto verdict = [](const Quality& quality, const std::string& of) {
    for (const QualityWish& wish : quality.wishes) {
      if (wish.what.find(of) != std::string::npos) return wish.met;
    }
    FAIL("no wish is about " + of);
    return false;
  };
  const Quality few = measured(world, 2);
  CHECK_FALSE(verdict(few, "kinds of ground"));  // it has three
  CHECK(verdict(few, "step"));
  CHECK_FALSE(verdict(few, "bed"));  // its two places have no river
}

TEST_CASE("The figures of the default world are text and JSON") {
  const Quality quality = measured(terrain::default_world(), 2);
  CHECK_THAT(to_text(quality), Catch::Contains("Power of heights"));
  const auto json = nlohmann::json::parse(to_json(quality));
  CHECK(json["bands"].size() == 6);
  CHECK(json["wanted"].size() == 7);
  CHECK(json["land_steeper_than"][2]["degrees"] == 60);
}
