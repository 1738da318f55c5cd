// What a person reads who made a mistake in a world.toml: a table of mistakes and whole messages, and
// of what was said before that.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include <talus/terrain/world.h>

#include "made_height_map.h"
#include "seed_of_run.h"
#include "spec/spec_errors.h"
#include "worlds.h"
#include "wrong_spec.h"

namespace talus::terrain {
namespace {

struct Mistake {
  std::string surface;  // of the small world: "" or "mirror"
  std::string from;
  std::string to;
  std::string message;
  std::string was;  // what it said before; "": the same
};

const std::string kLongKey(5000, 'k');

const Mistake kMistakes[] = {
    // A height map's file: the line of what is to blame.
    {"mirror", "made.png", "none.png", "w.toml:9: surface.height_map.file: 'none.png': no such map", ""},
    {"mirror", "x = -1.3", "x = \"west\"",
     "w.toml:10: surface.height_map.x: 'west' is a string; a number is needed",
     "w.toml:10: surface.height_map.x: is not right as it stands (string); a number is needed"},
    {"mirror", "spacing = 0.21", "spacing = 0.21\nlow = 9\nhigh = 8",
     "w.toml:14: surface.height_map.high: low is 9 and high 8; low must be below high",
     "w.toml:9: surface.height_map.file: 'made.png': low is 9 and high 8; low must be below high"},
    {"mirror", "spacing = 0.21", "spacing = 0.21\nlow = 70000",
     "w.toml:13: surface.height_map.low: low is 70000 and high 65535; low must be below high",
     "w.toml:9: surface.height_map.file: 'made.png': low is 70000 and high 65535; low must be below high"},
    // One range, in plain numbers.
    {"", "amplitude = 2.5", "amplitude = 1000",
     "w.toml:10: surface.amplitude: 1000 is out of range; 1/65536 to 819.2 (at most 32768 voxels at "
     "resolution "
     "40)",
     "w.toml:10: surface.amplitude: amplitude * resolution is 40000 voxels; at most 32768"},
    {"", "amplitude = 2.5", "amplitude = 0",
     "w.toml:10: surface.amplitude: 0 is out of range; 1/65536 to 819.2 (at most 32768 voxels at resolution "
     "40)",
     "w.toml:10: surface.amplitude: 0 is out of range; 1.52588e-05 to 32768"},
    {"", "wavelength = 2.0\noctaves", "wavelength = 0\noctaves",
     "w.toml:6: surface.wavelength: 0 is out of range; 0.05 to 419430.4 (2 to 16777216 voxels at resolution "
     "40)",
     "w.toml:6: surface.wavelength: 0 is out of range; 1e-06 to 1.67772e+07"},
    {"", "wavelength = 2.0\noctaves", "wavelength = 1e30\noctaves",
     "w.toml:6: surface.wavelength: 1e30 is out of range; 0.05 to 419430.4 (2 to 16777216 voxels at "
     "resolution "
     "40)",
     "w.toml:6: surface.wavelength: 1e+30 is out of range; 1e-06 to 1.67772e+07"},
    {"mirror", "spacing = 0.21", "spacing = 0",
     "w.toml:12: surface.height_map.spacing: 0 is out of range; 0.025 to 102.4 (1 to 4096 voxels at "
     "resolution "
     "40)",
     "w.toml:12: surface.height_map.spacing: 0 is out of range; 1e-06 to 1.67772e+07"},
    {"mirror", "spacing = 0.21", "spacing = 0.01",
     "w.toml:12: surface.height_map.spacing: 0.01 is out of range; 0.025 to 102.4 (1 to 4096 voxels at "
     "resolution 40)",
     "w.toml:12: surface.height_map.spacing: spacing * resolution is 0.4 voxels; 1 to 4096"},
    {"", "thickness = 0.5", "thickness = 1e-7",
     "w.toml:15: stratified[0].thickness: 0.0000001 is out of range; 1/65536 to 32768",
     "w.toml:15: stratified[0].thickness: 1e-07 is out of range; 1.52588e-05 to 32768"},
    // A value is shown, and what it should be.
    {"", "colour = \"#444444\"", "colour = \"red\"",
     "w.toml:13: stratified[0].colour: 'red' is not a colour; \"#rrggbb\", as \"#8d8478\", is needed",
     "w.toml:13: stratified[0].colour: is not right as it stands (string); a string such as \"#8d8478\" is "
     "needed"},
    {"", "colour = \"#444444\"", "colour = 4",
     "w.toml:13: stratified[0].colour: 4 is an integer; \"#rrggbb\", as \"#8d8478\", is needed",
     "w.toml:13: stratified[0].colour: is not right as it stands (integer); a string such as \"#8d8478\" is "
     "needed"},
    {"", "gain = 1.0", "gain = true", "w.toml:8: surface.gain: true is a boolean; a number is needed",
     "w.toml:8: surface.gain: is not right as it stands (boolean); a number is needed"},
    {"", "seed = 1", "seed = 1.0", "w.toml:1: seed: 1.0 is a floating-point number; an integer is needed",
     ""},
    {"", "seed = 1", "seed = 1.5", "w.toml:1: seed: 1.5 is a floating-point number; an integer is needed",
     "w.toml:1: seed: is not right as it stands (floating-point); an integer is needed"},
    // A long key or value is cut.
    {"", "gain = 1.0", "gain = 1.0\n" + kLongKey + " = 1",
     "w.toml:9: surface." + kLongKey.substr(0, 117) +
         "...: unknown key; known here: wavelength, octaves, gain, exponent, amplitude, kind",
     "w.toml:9: surface." + kLongKey +
         ": unknown key; known here: wavelength, octaves, gain, exponent, amplitude, kind"},
    {"", "colour = \"#444444\"", "colour = \"" + kLongKey + "\"",
     "w.toml:13: stratified[0].colour: '" + kLongKey.substr(0, 57) +
         "...' is not a colour; \"#rrggbb\", as \"#8d8478\", is needed",
     "w.toml:13: stratified[0].colour: is not right as it stands (string); a string such as \"#8d8478\" is "
     "needed"},
    // What is no TOML names its key where it has one.
    {"", "seed = 1", "seed =", "w.toml:1: seed: not TOML: expected value, saw '\\n'",
     "w.toml:1: not TOML: Error while parsing key-value pair: expected value, saw '\\n'"},
    {"", "gain = 1.0", "gain = high",
     "w.toml:8: surface.gain: not TOML: this is not a value: a string needs quotes",
     "w.toml:8: not TOML: Error while parsing value: could not determine value type"},
    {"", "thickness = 0.5", "thickness = 0.5.5",
     "w.toml:15: stratified[0].thickness: not TOML: expected decimal digit or exponent, saw '.'",
     "w.toml:15: not TOML: Error while parsing floating-point: expected decimal digit or exponent, saw '.'"},
    {"", "gain = 1.0", "gain = 1.0\ngain = 2.0",
     "w.toml:9: surface.gain: not TOML: cannot redefine existing floating-point 'gain'",
     "w.toml:9: not TOML: Error while parsing key-value pair: cannot redefine existing floating-point "
     "'gain'"},
    {"", "[surface]", "[surface", "w.toml:5: not TOML: table header: expected ']', saw '\\n'",
     "w.toml:5: not TOML: Error while parsing table header: expected ']', saw '\\n'"},
};

tl::expected<HeightMap, std::string> load(const std::string& file) {
  if (file != "made.png") return tl::unexpected(std::string{"no such map"});
  return test::made_height_map();
}

TEST_CASE("Every mistake in a world.toml has its message") {
  for (const auto& [surface, from, to, message, was] : kMistakes) {
    const std::string text = surface.empty() ? test::small_world_text(1) : test::small_world_text(1, surface);
    INFO(from << " -> " << to.substr(0, 100));
    const auto world = World::parse(test::replaced(text, from, to), "w.toml", load);
    REQUIRE_FALSE(world);
    CHECK(world.error().message == message);
    CHECK(world.error().message != was);
  }
}

TEST_CASE("Too much lift is blamed on the key that adds most of it") {
  const std::string world = test::small_world_text(1);
  const auto features = [](const char* amplitude, const char* first, const char* second) {
    return std::string{"[folds]\nwavelength = 9\namplitude = "} + amplitude +
           "\n[[faults]]\nstrike = 0\nspacing = 9\nthrow = " + first +
           "\n[[faults]]\nstrike = 9\nspacing = 9\nthrow = " + second + "\n";
  };
  const std::string terms = ": surface.amplitude, folds.amplitude, half of every throw, * resolution, are ";
  const auto error = [&](const auto&... values) { return test::error_of(world + features(values...)); };
  CHECK_THAT(error("10", "30", "3000"),
             Catch::Contains(": faults[1].throw" + terms + "61100 voxels in all; at most 32768"));
  CHECK_THAT(error("10", "3000", "30"), Catch::Contains(": faults[0].throw" + terms));
  CHECK_THAT(error("1000", "30", "30"), Catch::Contains(": folds.amplitude" + terms));
  // It was blamed on folds.amplitude, whoever added it.
  CHECK(error("10", "30", "3000") !=
        "w.toml:59: folds.amplitude" + terms + "61100 voxels in all; at most 32768");
  const std::string blamed = error("10", "30", "3000");
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  CHECK_THAT(blamed,
             Catch::StartsWith("w.toml:" + std::to_string(lines(world + features("", "", ""))) + ":"));
}

TEST_CASE("Numbers are written as a person writes them") {
  CHECK(plain(0) == "0");
  CHECK(plain(-1) == "-1");
  CHECK(plain(16777216) == "16777216");
  CHECK(plain(-68719476736.0) == "-68719476736");
  CHECK(plain(0.000001) == "0.000001");
  CHECK(plain(0.1 * 3) == "0.3");
  CHECK(plain(1.0 / 65536) == "1/65536");
  CHECK(plain(0.5) == "0.5");
  CHECK(plain(1e9) == "1000000000");
  CHECK(plain(1e18) == "1e18");
  CHECK(plain(-2.5e-20) == "-2.5e-20");
  CHECK(plain(std::numeric_limits<double>::infinity()) == "inf");
}

TEST_CASE("Numbers are rounded to twelve digits, half to even, as printf rounds them") {
  CHECK(plain(100000000000.5) == "100000000000");
  CHECK(plain(100000000001.5) == "100000000002");
  CHECK(plain(999999999999.5) == "1000000000000");
  CHECK(plain(std::numeric_limits<double>::denorm_min()) == "4.94065645841e-324");
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937_64 random{seed};
  for (int i = 0; i < 10'000; ++i) {
    const auto number = std::bit_cast<double>(random());
    if (!std::isfinite(number)) continue;
    const std::string written = plain(number);
    if (written.starts_with("1/")) continue;
    std::array<char, 32> rounded{};
    std::snprintf(rounded.data(), rounded.size(), "%.11e", number);
    CAPTURE(written);
    REQUIRE(std::strtod(written.c_str(), nullptr) == std::strtod(rounded.data(), nullptr));
  }
}

TEST_CASE("Lines are the file's, with returns at their ends, comments and blank lines") {
  std::string text = test::replaced(test::small_world_text(1), "gain = 1.0", "gain = 99");
  CHECK_THAT(test::error_of(text), Catch::StartsWith("w.toml:8: surface.gain: "));
  text = "# \xe2\x80\xa8 a separator of lines elsewhere\n\n" + text;
  CHECK_THAT(test::error_of(text), Catch::StartsWith("w.toml:10: surface.gain: "));
  std::string returns;
  for (const char c : text) returns += c == '\n' ? std::string{"\r\n"} : std::string{c};
  CHECK_THAT(test::error_of(returns), Catch::StartsWith("w.toml:10: surface.gain: "));
}

}  // namespace
}  // namespace talus::terrain
