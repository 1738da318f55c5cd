#include <catch2/catch.hpp>

#include <string>

#include <talus/terrain/world.h>

#include "worlds.h"
#include "wrong_spec.h"

namespace talus::terrain {
namespace {

using test::error_of;
using test::Wrong;

std::string with(const std::string& from, const std::string& to) {
  const std::string text = test::small_caves_text(1);
  return test::replaced(text, from, to, text.find("[caves]"));
}

TEST_CASE("Wrong caves are refused with file, line, key and what would be right") {
  // [caves] stands on line 56.
  const auto [from, to, message] = GENERATE(values<Wrong>({
      {"low = 0.1\n", "", "w.toml:56: caves.low: missing; a number is needed"},
      {"span = 0.4\n", "", "w.toml:56: caves.span: missing; a number is needed"},
      {"low = 0.1", "low = \"deep\"", "w.toml:57: caves.low: 'deep' is a string; a number is needed"},
      {"low = 0.1", "low = -1", "w.toml:57: caves.low: -1 is out of range; 0 to 819.2 ("},
      {"low = 0.1", "low = 900", "w.toml:57: caves.low: 900 is out of range; "},
      {"high = 1.3", "high = 900", "w.toml:58: caves.high: 900 is out of range; "},
      {"high = 1.3", "high = 0.05", "w.toml:58: caves.high: 0.05 is less than low; at least 0.1"},
      {"climb_wavelength = 3.0", "climb_wavelength = 0.04",
       "w.toml:59: caves.climb_wavelength: 0.04 is out of range; "},
      {"\nwavelength = 1.5", "\nwavelength = 0.04", "w.toml:60: caves.wavelength: 0.04 is out of range; "},
      {"width = 0.2", "width = 0", "w.toml:61: caves.width: 0 is out of range"},
      {"width = 0.2", "width = 0.001",
       "w.toml:61: caves.width: 0.001 is out of range; 0.00146484375 to 0.75"},
      {"width = 0.2", "width = 0.8", "w.toml:61: caves.width: 0.8 is out of range; 0.00146484375 to 0.75"},
      {"\nheight = 0.25", "\nheight = 0.02", "w.toml:62: caves.height: 0.02 is out of range; "},
      {"\nheight = 0.25", "\nheight = 103", "w.toml:62: caves.height: 103 is out of range; "},
      {"chamber_wavelength = 1.2", "chamber_wavelength = 500000",
       "w.toml:63: caves.chamber_wavelength: 500000 is out of range; "},
      {"chamber_threshold = 0.25", "chamber_threshold = 1.1",
       "w.toml:64: caves.chamber_threshold: 1.1 is out of range; 0 to 1"},
      {"chamber_height = 0.6", "chamber_height = 0.01",
       "w.toml:65: caves.chamber_height: 0.01 is out of range; "},
      {"roof = 0.05", "roof = -1",
       "w.toml:66: caves.roof: -1 is out of range; 0 to 6.4 (0 to 256 voxels at resolution 40)"},
      {"roof = 0.05", "roof = 7", "w.toml:66: caves.roof: 7 is out of range; "},
      {"span = 0.4", "span = 0.01", "w.toml:67: caves.span: 0.01 is out of range; "},
      {"span = 0.4", "span = 2", "w.toml:67: caves.span: 2 is out of range; "},
      {"span = 0.4", "span = nan", "w.toml:67: caves.span: nan is out of range"},
      {"span = 0.4", "span = 0.4\ndoor = 1", "w.toml:68: caves.door: unknown key; known here: low, high"},
      {"[caves]", "[[caves]]", "w.toml:56: caves: an array; a table [caves] is needed"},
  }));
  INFO(to);
  const std::string error = error_of(with(from, to));
  INFO(error);
  CHECK(error.find(message) == 0);
}

TEST_CASE("A roof is as thin as voxels allow where the spec says nothing") {
  CHECK(World::parse(with("roof = 0.05\n", ""), "w.toml")->fingerprint() ==
        World::parse(with("roof = 0.05\n", "roof = 0\n"), "w.toml")->fingerprint());
}

TEST_CASE("Every key of the caves is in the fingerprint") {
  const ContentHash before = test::small_caves(1).fingerprint();
  CHECK(before != test::small_world(1).fingerprint());
  const auto changed = [&](const std::string& from, const std::string& to) {
    return World::parse(with(from, to), "w.toml").value().fingerprint() != before;
  };
  CHECK(changed("low = 0.1", "low = 0.2"));
  CHECK(changed("high = 1.3", "high = 1.2"));
  CHECK(changed("climb_wavelength = 3.0", "climb_wavelength = 3.1"));
  CHECK(changed("\nwavelength = 1.5", "\nwavelength = 1.6"));
  CHECK(changed("width = 0.2", "width = 0.21"));
  CHECK(changed("\nheight = 0.25", "\nheight = 0.26"));
  CHECK(changed("chamber_wavelength = 1.2", "chamber_wavelength = 1.3"));
  CHECK(changed("chamber_threshold = 0.25", "chamber_threshold = 0.26"));
  CHECK(changed("chamber_height = 0.6", "chamber_height = 0.61"));
  CHECK(changed("roof = 0.05", "roof = 0.06"));
  CHECK(changed("span = 0.4", "span = 0.5"));
}

}  // namespace
}  // namespace talus::terrain
