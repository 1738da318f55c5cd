#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include <talus/terrain/world.h>

#include "feature.h"
#include "worlds.h"
#include "wrong_spec.h"

namespace talus::terrain {
namespace {

using test::Wrong;

std::string with(const std::string& from, const std::string& to) {
  const std::string text = test::small_world_text(1) + test::underground_text();
  return test::replaced(text, from, to, text.rfind(from));
}

TEST_CASE(
    "Every wrong key of folds, faults and veins is refused with file, line, key and what would be right") {
  // [folds] stands on line 56, the [[faults]] on 62 and 67, the [[veins]] on 71, 80 and 88.
  const auto [from, to, message] = GENERATE(values<Wrong>({
      {"amplitude = 0.6", "", "w.toml:56: folds.amplitude: missing; a number is needed"},
      {"amplitude = 0.6", "amplitude = -1", "w.toml:57: folds.amplitude: -1 is out of range; 0 to 32768"},
      {"amplitude = 0.6", "amplitude = 900",
       "w.toml:57: folds.amplitude: surface.amplitude, folds.amplitude"},
      {"wavelength = 1.6", "wavelength = 0.3", "w.toml:58: folds.wavelength: 0.3 is out of range; "},
      {"octaves = 2", "octaves = 9", "w.toml:59: folds.octaves: 9 is out of range; 1 to 8"},
      {"strike = 30", "strike = 400", "w.toml:60: folds.strike: 400 is out of range; -360 to 360"},
      {"stretch = 4", "stretch = 0.5", "w.toml:61: folds.stretch: 0.5 is out of range; 1 to 64"},
      {"stretch = 4", "stretsch = 4", "w.toml:61: folds.stretsch: unknown key; known here: amplitude, "},
      {"strike = 20", "strike = \"north\"", "w.toml:63: faults[0].strike: "},
      {"strike = 20", "", "w.toml:62: faults[0].strike: missing; a number is needed"},
      {"spacing = 0.9", "spacing = 0.1", "w.toml:64: faults[0].spacing: 0.1 is out of range; "},
      {"throw = 0.5", "throw = -0.5", "w.toml:65: faults[0].throw: -0.5 is out of range; 0 to 32768"},
      {"throw = 0.5", "throw = 2000", "w.toml:65: faults[0].throw: surface.amplitude, folds.amplitude"},
      {"waviness = 0.1", "waviness = 500", "w.toml:66: faults[0].waviness: 500 is out of range; "},
      {"waviness = 0.1", "wavyness = 0.1", "w.toml:66: faults[0].wavyness: unknown key"},
      {"[[faults]]\nstrike = 115", "[fualts]\nstrike = 115",
       "w.toml:67: fualts: unknown key; known here: seed"},
      {"name = \"gold\"", "name = \"coal\"", "veins[1].name: 'coal' names another material already"},
      {"name = \"gold\"", "name = \"sand\"", "veins[1].name: 'sand' names another material already"},
      {"colour = \"#ffd020\"", "colour = \"gold\"", "w.toml:82: veins[1].colour: "},
      {"shape = \"vein\"", "shape = \"cube\"",
       "w.toml:74: veins[0].shape: 'cube' is not one of: pocket, vein"},
      {"shape = \"vein\"", "shape = \"pocket\"",
       "w.toml:78: veins[0].thickness: unknown key; known here: name, "},
      {"thickness = 0.06\n", "", "w.toml:71: veins[0].thickness: missing; a number is needed"},
      {"thickness = 0.06", "thickness = 0.02", "w.toml:78: veins[0].thickness: 0.02 is out of range; "},
      {"thickness = 0.06", "thickness = 0.3", "w.toml:78: veins[0].thickness: more than a quarter of size"},
      {"low = 0.1", "low = -0.1", "w.toml:75: veins[0].low: -0.1 is out of range; 0 to 32768"},
      {"low = 0.1", "low = 1.8", "w.toml:76: veins[0].high: less than size above low, so that no body fits"},
      {"high = 2.4", "high = 1000", "w.toml:76: veins[0].high: 1000 is out of range; "},
      {"size = 0.9", "size = 100", "w.toml:77: veins[0].size: 100 is out of range; "},
      {"size = 0.12", "size = 0.05", "w.toml:94: veins[2].size: 0.05 is out of range; "},
      {"abundance = 0.9", "abundance = 1.5", "w.toml:79: veins[0].abundance: 1.5 is out of range; 0 to 1"},
      {"abundance = 0.9", "abundance = true", "w.toml:79: veins[0].abundance: "},
  }));
  INFO(from << " -> " << to);
  const auto world = World::parse(with(from, to), "w.toml");
  REQUIRE_FALSE(world);
  CHECK_THAT(world.error().message, Catch::Contains(message));
  CHECK_THAT(world.error().message, Catch::StartsWith("w.toml:"));
  CHECK(world.error().message.find('\n') == std::string::npos);
}

TEST_CASE("More than eight sets of faults or sixteen ores are refused") {
  std::string faults = test::small_world_text(1);
  for (int i = 0; i < 9; ++i) faults += "[[faults]]\nstrike = 20\nspacing = 0.9\nthrow = 0.1\n";
  const auto cut = World::parse(faults, "w.toml");
  REQUIRE_FALSE(cut);
  CHECK_THAT(cut.error().message, Catch::Contains("faults[8].spacing: 9 sets of faults; at most 8"));
  std::string ores = test::small_world_text(1);
  for (int i = 0; i < 17; ++i) {
    ores += "[[veins]]\nname = \"o" + std::to_string(i) +
            "\"\ncolour = \"#ffffff\"\nshape = \"pocket\"\nlow = 0\nhigh = 1\nsize = 0.2\nabundance = 0.1\n";
  }
  const auto rich = World::parse(ores, "w.toml");
  REQUIRE_FALSE(rich);
  CHECK_THAT(rich.error().message, Catch::Contains("veins[16].name: 17 ores; at most 16"));
}

TEST_CASE("Every key of folds, faults and veins that decides a voxel is in the fingerprint") {
  const auto fingerprint = [](const std::string& from, const std::string& to) {
    const auto world = World::parse(with(from, to), "w.toml");
    REQUIRE(world);
    return world->fingerprint();
  };
  const ContentHash plain = fingerprint("octaves = 2", "octaves = 2");
  CHECK(plain != test::small_world(1).fingerprint());
  CHECK(fingerprint("\"gold\"", "\"silver\"") == plain);
  CHECK(fingerprint("#ffd020", "#c0c0c0") == plain);
  const auto [from, to] = GENERATE(table<std::string, std::string>({
      {"amplitude = 0.6", "amplitude = 0.61"},
      {"wavelength = 1.6", "wavelength = 1.7"},
      {"octaves = 2", "octaves = 3"},
      {"strike = 30", "strike = 31"},
      {"stretch = 4", "stretch = 5"},
      {"strike = 20", "strike = 21"},
      {"spacing = 0.9", "spacing = 0.91"},
      {"throw = 0.5", "throw = 0.51"},
      {"waviness = 0.1", "waviness = 0.11"},
      {"shape = \"vein\"\nlow = 0.1\nhigh = 2.4\nsize = 0.9\nthickness = 0.06",
       "shape = \"pocket\"\nlow = 0.1\nhigh = 2.4\nsize = 0.9"},
      {"low = 0.1", "low = 0.11"},
      {"high = 2.4", "high = 2.41"},
      {"size = 0.9", "size = 0.91"},
      {"thickness = 0.06", "thickness = 0.07"},
      {"abundance = 0.9", "abundance = 0.91"},
  }));
  INFO(from << " -> " << to);
  CHECK(fingerprint(from, to) != plain);
}

TEST_CASE("Ores come after all other materials, so that no other id moves") {
  const World world = World::parse(test::small_world_text(1) + test::underground_text(), "w.toml").value();
  std::string names;
  for (const Material& material : world.materials()) names += material.name + " ";
  CHECK(names == "air water basalt chalk clay limestone gravel sand soil coal gold opal ");
  CHECK(world.materials().back().kind == MaterialKind::stratified);
}

TEST_CASE("A world has one kind of caves, as a column has one interval of air") {
  std::vector<FeatureKind> kinds(shipped_features().begin(), shipped_features().end());
  const auto caves = std::find_if(kinds.begin(), kinds.end(),
                                  [](const FeatureKind& kind) { return kind.section == "caves"; });
  REQUIRE(caves != kinds.end());
  FeatureKind second = *caves;
  second.section = "tunnels";
  kinds.push_back(second);
  const std::string one = test::small_caves_text(1);
  std::string other = one.substr(one.find("[caves]"));
  other.replace(0, 7, "[tunnels]");
  CHECK(World::parse(one, "w.toml", {}, kinds));
  const auto both = World::parse(one + other, "w.toml", {}, kinds);
  REQUIRE_FALSE(both);
  CHECK(both.error().message ==
        "w.toml:68: tunnels: a world has one kind of caves; leave this or [caves] out");
}

}  // namespace
}  // namespace talus::terrain
