// A world of kind "regions" whose soil has looks, for tests of what is drawn and measured of them.
#pragma once

#include <string>

#include <catch2/catch.hpp>

#include <talus/terrain/world.h>

namespace talus::test {

[[nodiscard]] inline std::string text_of_world_with_looks() {
  return R"(
seed = 7
resolution = 1
sea_level = 128
strata_wavelength = 300
[surface]
kind = "regions"
[[stratified]]
name = "granite"
colour = "#767076"
depth = 900
thickness = 900
roughness = 0.5
[[eroded]]
name = "soil"
colour = "#7a5b3e"
weight = 2
thickness = 4
angle_of_repose = 31
max_slope = 43
[[eroded]]
name = "snow"
colour = "#f4f7fa"
weight = 1
thickness = 3
angle_of_repose = 38
max_slope = 50
where = { temperature = [-0.50, -0.60] }
[[look]]
name = "sea floor"
of = "soil"
below = { height = -7 }
colour = "#8d8a6e"
[[look]]
name = "desert"
of = "soil"
below = { moisture = -0.3 }
above = { temperature = 0 }
colour = "#dcbd80"
[[look]]
name = "nowhere"
of = "soil"
above = { height = 2000 }
colour = "#ff00ff"
[[look]]
name = "meadow"
of = "soil"
colour = "#7fa84a"
[[look]]
name = "ice"
of = "water"
below = { temperature = -0.62 }
colour = "#cfe3ee"
)";
}

[[nodiscard]] inline terrain::World world_with_looks() {
  auto world = terrain::World::parse(text_of_world_with_looks(), "looks.toml");
  INFO((world ? "" : world.error().message));
  REQUIRE(world);
  return std::move(*world);
}

}  // namespace talus::test
