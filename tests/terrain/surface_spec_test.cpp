// The keys of surfaces other than the thesis': what is refused, and what the fingerprint covers.
#include <catch2/catch.hpp>

#include <string>

#include <talus/terrain/world.h>

#include "made_height_map.h"
#include "worlds.h"
#include "wrong_spec.h"

namespace talus::terrain {
namespace {

std::string with(const std::string& surface, const std::string& from, const std::string& to) {
  return test::replaced(surface.empty() ? test::small_world_text(1) : test::small_world_text(1, surface),
                        from, to);
}

struct Wrong {
  std::string surface;
  std::string from;
  std::string to;
  std::string message;
};

TEST_CASE("Every wrong key of a surface is refused with file, line, key and what would be right") {
  const auto [surface, from, to, message] = GENERATE(values<Wrong>({
      {"", "gain = 1.0", "gain = 1.0\nkind = \"flat\"",
       "w.toml:9: surface.kind: 'flat' is not one of: perlin, ridged, warped, height_map"},
      {"", "gain = 1.0", "gain = 1.0\nkind = 3", "w.toml:9: surface.kind: "},
      {"", "gain = 1.0", "gain = 1.0\nfeedback = 2",
       "w.toml:9: surface.feedback: unknown key; known here: wavelength"},
      {"", "gain = 1.0", "gain = 1.0\nwarp = 2", "w.toml:9: surface.warp: unknown key"},
      {"ridged", "feedback = 3", "feedback = 17", "w.toml:8: surface.feedback: 17 is out of range; 0 to 16"},
      {"ridged", "feedback = 3", "feedback = \"a\"", "w.toml:8: surface.feedback: "},
      {"ridged", "feedback = 3", "warp = 3", "w.toml:8: surface.warp: unknown key"},
      {"warped", "warp = 0.8\n", "", "w.toml:5: surface.warp: missing; a number is needed"},
      {"warped", "warp = 0.8", "warp = -1",
       "w.toml:8: surface.warp: -1 is out of range; 0 to 409.6 (0 to 16384 voxels at resolution 40)"},
      {"warped", "warp = 0.8", "warp = 500", "w.toml:8: surface.warp: 500 is out of range; "},
      {"warped", "warp_wavelength = 2.4", "warp_wavelength = 0.01",
       "surface.warp_wavelength: 0.01 is out of range; "},
      {"warped", "warp_wavelength = 2.4", "warp_octaves = 0",
       "w.toml:9: surface.warp_octaves: 0 is out of range; 1 to 16"},
      {"mirror", "kind = \"height_map\"", "kind = \"perlin\"", "surface.height_map: unknown key"},
      {"", "gain = 1.0", "kind = \"height_map\"", "surface.height_map: missing; a table [height_map]"},
      {"", "gain = 1.0", "kind = \"height_map\"\nheight_map = 3",
       "w.toml:9: surface.height_map: 3 is an integer; "},
      {"mirror", "amplitude = 2.5", "amplitude = 2.5\nwavelength = 2",
       "w.toml:7: surface.wavelength: unknown key; known here: amplitude, kind, height_map"},
      {"mirror", "strata_wavelength = 1.5\n", "", "strata_wavelength: missing; a number is needed"},
      {"mirror", "file = \"made.png\"\n", "", "surface.height_map.file: missing; a string is needed"},
      {"mirror", "file = \"made.png\"", "file = \"\"",
       "surface.height_map.file: 1 to 1024 bytes, this has 0"},
      {"mirror", "x = -1.3\n", "", "surface.height_map.x: missing; a number is needed"},
      {"mirror", "x = -1.3", "x = 1e12", "surface.height_map.x: 1000000000000 is out of range"},
      {"mirror", "x = -1.3", "x = 6e10", "surface.height_map.x: 60000000000 is out of range; "},
      {"mirror", "spacing = 0.21", "spacing = 0.01", "surface.height_map.spacing: 0.01 is out of range; "},
      {"mirror", "spacing_z = 0.17", "spacing_z = 200",
       "surface.height_map.spacing_z: 200 is out of range; "},
      {"mirror", "outside = \"mirror\"", "outside = \"void\"",
       "surface.height_map.outside: 'void' is not one of: mirror, sea, blend, repeat"},
      {"mirror", "outside = \"mirror\"", "", "surface.height_map.outside: missing; a string is needed"},
      {"mirror", "spacing = 0.21", "spacing = 0.21\nmargin = 1", "surface.height_map.margin: unknown key"},
      {"repeat", "spacing = 0.21", "spacing = 0.21\naround = \"perlin\"",
       "surface.height_map.around: unknown key"},
      {"mirror", "spacing = 0.21", "spacing = 0.21\nlow = \"a\"", "surface.height_map.low: "},
      {"mirror", "spacing = 0.21", "spacing = 0.21\nlow = 9\nhigh = 8",
       "surface.height_map.high: low is 9 and high 8; low must be below high"},
      {"blend", "margin = 1.5\n", "", "surface.height_map.margin: missing; a number is needed"},
      {"blend", "margin = 1.5", "margin = 0.001", "surface.height_map.margin: 0.001 is out of range; "},
      {"blend", "margin = 1.5", "margin = 1.5\naround = \"height_map\"",
       "surface.height_map.around: 'height_map' is not one of: perlin, ridged, warped"},
      {"blend", "octaves = 5\n", "", "surface.octaves: missing; an integer is needed"},
      {"blend", "wavelength = 2.0\n", "wavelength = 0.01\n", "surface.wavelength: 0.01 is out of range; "},
  }));
  INFO(surface << ": " << from << " -> " << to);
  const auto world = World::parse(with(surface, from, to), "w.toml", test::made_height_maps());
  const std::string error = world ? "accepted" : world.error().message;
  CHECK_THAT(error, Catch::Contains(message));
  CHECK_THAT(error, Catch::StartsWith("w.toml:"));
  CHECK(error.find('\n') == std::string::npos);
}

TEST_CASE("A height map that cannot be had refuses its world, on one line") {
  const std::string text = test::small_world_text(1, "mirror");
  const auto none = World::parse(text, "w.toml");
  REQUIRE_FALSE(none);
  CHECK_THAT(none.error().message, Catch::Contains("'made.png': height maps cannot be read here"));
  const auto broken = World::parse(with("mirror", "made.png", "a\\nb"), "w.toml", [](const std::string&) {
    return tl::expected<HeightMap, std::string>{tl::unexpected(std::string{"is not\na PNG"})};
  });
  REQUIRE_FALSE(broken);
  CHECK_THAT(broken.error().message, Catch::Contains("surface.height_map.file: 'a\\x0ab': is not\\x0aa PNG"));
}

TEST_CASE("The thesis' surface named by its kind is the one that stands there unnamed") {
  const auto named = World::parse(with("", "gain = 1.0", "gain = 1.0\nkind = \"perlin\""), "w.toml");
  REQUIRE(named);
  CHECK(named->fingerprint() == test::small_world(1).fingerprint());
}

TEST_CASE("The fingerprint covers every key of every surface") {
  const auto [surface, from, to, message] = GENERATE(values<Wrong>({
      {"ridged", "feedback = 3", "feedback = 4", ""},
      {"warped", "warp = 0.8", "warp = 0.7", ""},
      {"warped", "warp_wavelength = 2.4", "warp_wavelength = 2.5", ""},
      {"warped", "warp_wavelength = 2.4", "warp_wavelength = 2.4\nwarp_octaves = 2", ""},
      {"mirror", "x = -1.3", "x = -1.2", ""},
      {"mirror", "z = 0.7", "z = 0.6", ""},
      {"mirror", "spacing = 0.21", "spacing = 0.22", ""},
      {"mirror", "spacing_z = 0.17", "spacing_z = 0.18", ""},
      {"mirror", "\"mirror\"", "\"sea\"", ""},
      {"mirror", "\"mirror\"", "\"repeat\"", ""},
      {"mirror", "spacing = 0.21", "spacing = 0.21\nlow = 77", ""},
      {"mirror", "spacing = 0.21", "spacing = 0.21\nhigh = 60000", ""},
      {"blend", "margin = 1.5", "margin = 1.6", ""},
      {"blend", "margin = 1.5", "margin = 1.5\naround = \"ridged\"", ""},
  }));
  INFO(surface << ": " << from << " -> " << to);
  const auto changed = World::parse(with(surface, from, to), "w.toml", test::made_height_maps());
  REQUIRE(changed);
  CHECK(changed->fingerprint() != test::small_world(1, surface).fingerprint());
}

TEST_CASE("The fingerprint covers what a height map holds, and not what its file is called") {
  const auto fingerprint = [](const std::string& text, std::size_t changed) {
    const auto world = World::parse(text, "w.toml", [&](const std::string&) {
      HeightMap map = test::made_height_map();
      auto& samples = std::get<std::vector<std::uint16_t>>(map.samples);
      if (changed < samples.size()) samples[changed] = static_cast<std::uint16_t>(samples[changed] + 2000);
      return tl::expected<HeightMap, std::string>{map};
    });
    REQUIRE(world);
    return world->fingerprint();
  };
  const std::string text = test::small_world_text(1, "mirror");
  const std::size_t none = 1000000;
  CHECK(fingerprint(text, none) == test::small_world(1, "mirror").fingerprint());
  CHECK(fingerprint(with("mirror", "made.png", "other.npy"), none) == fingerprint(text, none));
  CHECK(fingerprint(text, 500) != fingerprint(text, none));
}

}  // namespace
}  // namespace talus::terrain
