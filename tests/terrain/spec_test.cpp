#include <catch2/catch.hpp>

#include <string>

#include <talus/terrain/world.h>
#include <talus/toml/toml_bounds.h>

#include "worlds.h"
#include "wrong_spec.h"

namespace talus::terrain {
namespace {

using test::error_of;
using test::Wrong;

std::string with(const std::string& from, const std::string& to) {
  return test::replaced(test::small_world_text(1), from, to);
}

TEST_CASE("A key with more parts than a parser's stack holds is refused before it is parsed") {
  std::string key = "a";
  for (int i = 0; i < 100'000; ++i) key += ".a";
  CHECK(error_of(test::small_world_text(1) + key + " = 1\n").find(": a key of more than 64 parts") !=
        std::string::npos);
  CHECK(error_of(test::small_world_text(1) + "[" + key + "]\n").find(": a key of more than 64 parts") !=
        std::string::npos);
  // Dots in a string, in a comment or after an escaped quote are none of a key's.
  const std::string dots(200, '.');
  CHECK(World::parse(with("name = \"chalk\"", "name = \"ch\\\"alk\" # " + dots), "w.toml"));
}

TEST_CASE("A string of several lines is refused, as it would hide a key's parts from their count") {
  std::string key = "a";
  for (int i = 0; i < 70'000; ++i) key += ".a";
  for (const std::string quotes : {"\"\"\"", "'''"}) {
    const std::string inner = quotes.substr(0, 1);
    CHECK(error_of("x = {y = " + quotes + "p" + inner + "q" + quotes + ", " + key + " = 1}\n") ==
          "w.toml:1: a string in three quotes; only strings of one line are read, in one quote");
  }
  CHECK(World::parse(with("seed = 1", "seed = 1 # \"\"\""), "w.toml"));
}

TEST_CASE("Brackets within brackets are bounded, so that parts of keys do not add up") {
  std::string deep = "x = ";
  for (int i = 0; i < 200; ++i) deep += "[\n{a.b.c.d.e.f.g.h = ";
  CHECK(error_of(deep) == "w.toml:9: more than 16 brackets within each other");
  std::string flat;
  for (int i = 0; i < 40; ++i) flat += "x" + std::to_string(i) + " = [[1, 2], [3]]\n";
  CHECK_THAT(error_of(flat + test::small_world_text(1)), Catch::Contains("unknown key"));
}

TEST_CASE("A picture in place of a world is refused as such") {
  CHECK(error_of("\x89PNG\r\n\x1a\n") == "w.toml:1: the file is not text");
  CHECK(World::parse("\xEF\xBB\xBF" + test::small_world_text(1), "w.toml"));
}

TEST_CASE("A file past a mebibyte is refused") {
  CHECK(error_of(std::string(kMaxTomlBytes + 1, '#')) == "w.toml:1: the file has over 1048576 bytes");
}

TEST_CASE("An error stays on one line, whatever the keys are called") {
  const std::string error = error_of(with("seed = 1", "seed = 1\n\"a\\n\\u001b\" = 3"));
  CHECK(error.find("a\\x0a\\x1b: unknown key") != std::string::npos);
  CHECK(error.find('\n') == std::string::npos);
}

TEST_CASE("Every wrong spec is refused with file, line, key and what would be right") {
  // seed stands on line 1, [surface] on 5, the first [[stratified]] on 11, the first [[eroded]] on 35.
  const auto [from, to, message] = GENERATE(values<Wrong>({
      {"seed = 1", "seed = ", "w.toml:1: seed: not TOML: "},
      {"seed = 1", "seed = 1.5", "w.toml:1: seed: "},
      {"seed = 1\n", "\n", "seed: missing; an integer is needed"},
      {"resolution = 40", "resolution = 0", "w.toml:2: resolution: 0 is out of range; 1 to 32768"},
      {"resolution = 40", "resolution = \"x\"", "w.toml:2: resolution: "},
      {"resolution = 40", "resolution = 40\nresolutoin = 3",
       "w.toml:3: resolutoin: unknown key; known here: seed, "},
      {"seed = 1", "seed = 1\nmethod = \"wind\"", "w.toml:2: method: 'wind' is not one of: slope, erosion"},
      {"seed = 1", "seed = 1\nmethod = 3", "w.toml:2: method: "},
      {"seed = 1", "seed = 1\nmethod = \"erosion\"",
       "w.toml:1: erosion_steps: missing; an integer is needed"},
      {"seed = 1", "seed = 1\nmethod = \"erosion\"\nerosion_steps = 65",
       "w.toml:3: erosion_steps: 65 is out of range; 1 to 64"},
      {"seed = 1", "seed = 1\nerosion_steps = 6",
       "w.toml:2: erosion_steps: is for method = \"erosion\"; leave it out or choose that method"},
      {"sea_level = 0.3", "sea_level = -1", "w.toml:4: sea_level: -1 is out of range; 0 to 819.2 ("},
      {"sea_level = 0.3", "sea_level = 900", "w.toml:4: sea_level: 900 is out of range; "},
      {"strata_wavelength = 1.5", "strata_wavelength = 1e6",
       "w.toml:3: strata_wavelength: 1000000 is out of range; "},
      {"wavelength = 2.0\noctaves", "octaves", "w.toml:5: surface.wavelength: missing; a number is needed"},
      {"wavelength = 2.0\noctaves", "wavelength = 1e6\noctaves",
       "w.toml:6: surface.wavelength: 1000000 is out of range; "},
      {"wavelength = 2.0\noctaves", "wavelength = nan\noctaves",
       "w.toml:6: surface.wavelength: nan is out of range"},
      {"octaves = 5", "octaves = 17", "w.toml:7: surface.octaves: 17 is out of range; 1 to 16"},
      {"gain = 1.0", "gain = true", "w.toml:8: surface.gain: "},
      {"gain = 1.0", "gian = 1.0",
       "w.toml:8: surface.gian: unknown key; known here: wavelength, octaves, gain"},
      {"exponent = 2", "exponent = 9", "w.toml:9: surface.exponent: 9 is out of range; 1 to 8"},
      {"exponent = 2", "exponent = 2.5", "w.toml:9: surface.exponent: "},
      {"amplitude = 2.5", "amplitude = 1000", "w.toml:10: surface.amplitude: 1000 is out of range; "},
      {"name = \"chalk\"", "name = \"basalt\"",
       "stratified[1].name: 'basalt' names another material already"},
      {"name = \"sand\"", "name = \"chalk\"", "eroded[1].name: 'chalk' names another material already"},
      {"name = \"sand\"", "name = \"water\"", "eroded[1].name: 'water' is the world's own"},
      {"name = \"sand\"", "name = \"\"", "eroded[1].name: a name has 1 to 64 bytes, this has 0"},
      {"name = \"sand\"", R"(name = "\u001b[2J")",
       "eroded[1].name: a name is printed as it is, so it holds no control characters"},
      {"colour = \"#444444\"", "colour = \"grey\"", "w.toml:13: stratified[0].colour: "},
      {"colour = \"#444444\"", "colour = 4", "w.toml:13: stratified[0].colour: "},
      {"thickness = 0.5", "thickness = 0", "w.toml:15: stratified[0].thickness: 0 is out of range"},
      {"thickness = 0.5", "thickness = inf", "w.toml:15: stratified[0].thickness: inf is out of range"},
      {"roughness = 0.4", "roughness = -0.1",
       "w.toml:16: stratified[0].roughness: -0.1 is out of range; 0 to 16"},
      {"depth = 2.0\n", "", "w.toml:11: stratified[0].depth: missing; a number is needed"},
      {"thickness = 0.20", "thickness = 200", "eroded[0].thickness: 200 is out of range; "},
      {"thickness = 0.20", "thickness = 2",
       "eroded[0].thickness: at this angle of repose it needs a halo of 103 columns; at most 64"},
      {"angle_of_repose = 38", "angle_of_repose = 90",
       "eroded[0].angle_of_repose: 90 is out of range; 1 to 89"},
      {"max_slope = 50", "max_slope = 0.5", "eroded[0].max_slope: 0.5 is out of range; 1 to 89"},
      {"weight = 2", "weight = \"heavy\"", "eroded[0].weight: "},
  }));
  INFO(from << " -> " << to);
  const std::string error = error_of(with(from, to));
  CHECK_THAT(error, Catch::Contains(message));
  CHECK_THAT(error, Catch::StartsWith("w.toml:"));
  CHECK(error.find('\n') == std::string::npos);
}

TEST_CASE("A world needs at least one material of each kind") {
  std::string text = test::small_world_text(1);
  const std::size_t eroded = text.find("[[eroded]]");
  CHECK_THAT(error_of(text.substr(0, eroded)),
             Catch::Contains("eroded: missing; at least one [[eroded]] is needed"));
  const std::size_t stratified = text.find("[[stratified]]");
  CHECK_THAT(error_of(text.substr(0, stratified) + text.substr(eroded)),
             Catch::Contains("stratified: missing; at least one [[stratified]] is needed"));
}

TEST_CASE("A spec with too many layers or materials is refused") {
  CHECK_THAT(error_of(with("thickness = 0.2\nroughness = 0.9", "thickness = 0.0001\nroughness = 0.9")),
             Catch::Contains("more than 256 layers"));
  std::string text = test::small_world_text(1);
  for (int i = 0; i < 255; ++i) {
    text += "[[stratified]]\nname = \"r" + std::to_string(i) +
            "\"\ncolour = \"#000000\"\ndepth = 1\nthickness = 1\nroughness = 0\n";
  }
  // At the entry that is one too many: the small world has four layers, and loose materials come after
  // layers.
  CHECK_THAT(error_of(text),
             Catch::Contains("name: 'r251' is one material too many: at most 255 besides air and water"));
}

TEST_CASE("The fingerprint covers what decides voxels, and no name or colour") {
  const ContentHash plain = test::small_world(1).fingerprint();
  const auto changed = [&](const std::string& from, const std::string& to) {
    const auto world = World::parse(with(from, to), "w.toml");
    REQUIRE(world);
    return world->fingerprint() != plain;
  };
  CHECK_FALSE(changed("\"chalk\"", "\"marl\""));
  CHECK_FALSE(changed("#eeeeee", "#eeeedd"));
  CHECK_FALSE(changed("weight = 2", "weight = 7"));
  CHECK_FALSE(changed("resolution = 40", "resolution = 40  # a comment"));
  CHECK(changed("seed = 1", "seed = 2"));
  CHECK(changed("weight = 2", "weight = 0"));
  CHECK(changed("sea_level = 0.3", "sea_level = 0.31"));
  CHECK(changed("sea_level = 0.3\n", ""));
  CHECK(changed("gain = 1.0", "gain = 1.01"));
  CHECK(changed("roughness = 1.5", "roughness = 1.6"));
  CHECK(changed("angle_of_repose = 38", "angle_of_repose = 39"));
}

TEST_CASE("Materials are air, water, then stratified, then eroded in the order of the spec") {
  const World world = test::small_world(1);
  std::string names;
  for (const Material& material : world.materials()) {
    CHECK(&material == &world.materials()[to_integer(material.id)]);
    names += material.name + " ";
  }
  CHECK(names == "air water basalt chalk clay limestone gravel sand soil ");
  // Heaviest lowest; of equal weight the first of the spec on top.
  CHECK(world.loose_bottom_up() == std::vector<std::size_t>{0, 2, 1});
}

TEST_CASE("The sample worlds parse, and the default one is built in") {
  for (const char* name :
       {"default", "classic", "archipelago", "mesas", "alpine", "canyon", "hills", "features"})
    CHECK(test::sample_world(name).halo() > 0);
  CHECK(default_world().fingerprint() == test::sample_world("default").fingerprint());
}

}  // namespace
}  // namespace talus::terrain
