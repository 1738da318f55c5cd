// The keys of regions, and worlds made by them. The file is the one that docs/WORLDS.md shows.
#include <catch2/catch.hpp>

#include <cstdint>
#include <string>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/world.h>
#include <talus/voxel/chunk.h>
#include <talus/voxel/content_hash.h>

#include "worlds.h"
#include "wrong_spec.h"

namespace talus::terrain {
namespace {

World parsed(const std::string& text) {
  auto world = World::parse(text, "w.toml");
  INFO((world ? "" : world.error().message));
  REQUIRE(world.has_value());
  return *std::move(world);
}

std::string with(const std::string& from, const std::string& to) {
  return test::replaced(test::regions_world_text(), from, to);
}

/// The same world without the keys that may be left out.
std::string short_text() {
  const std::string text = test::regions_world_text();
  const std::size_t fields = text.find("[[field]]");
  const std::size_t surface = text.find("[surface]");
  const std::size_t materials = text.find("[strata]");
  return text.substr(0, fields) + text.substr(surface, text.find("[surface.land]") - surface) +
         text.substr(materials);
}

TEST_CASE("The defaults of regions are what WORLDS.md says") {
  const World whole = parsed(test::regions_world_text());
  CHECK(parsed(short_text()).fingerprint() == whole.fingerprint());
  CHECK(whole.generator_version() == GeneratorVersion::v3);
  CHECK(whole.highest_fx() == static_cast<std::int32_t>((128 + 52 + 70 + 110 + 1.12 * 270 + 95) * 256 + 0.5));
}

TEST_CASE("Every key of regions decides the fingerprint") {
  const auto [from, to] = GENERATE(values<std::pair<std::string, std::string>>({
      {"sea_level = 128", "sea_level = 192"},
      {"wavelength = 9000", "wavelength = 8000"},
      {"wavelength = 7000", "wavelength = 7001"},
      {"octaves = 7", "octaves = 6"},
      {"gain = 0.5\nwarp = 1", "gain = 0.51\nwarp = 1"},
      {"warp = 1", "warp = 0"},
      {"octaves = 3\ngain = 0.5\n", "octaves = 3\ngain = 0.5\nwarp = 1\n"},
      {"wavelength = 15000", "wavelength = 15001"},
      {"field = \"mesas\"", "field = \"moisture\""},
      {"[-0.2, 1.5]", "[-0.2, 1.6]"},
      {"[-0.5, 0.1]", "[-0.5, 0.2]"},
      {"[0.28, 0.5]", "[0.28, 0.6]"},
      {"[-0.7, 0.12]", "[-0.7, 0.13]"},
      {"base = 70", "base = 71"},
      {"relief = 270", "relief = 271"},
      {"[0.7, 80]", "[0.7, 81]"},
      {"[0.24, 0.66]", "[0.24, 0.67]"},
      {"height = 95", "height = 94"},
      {"anywhere = 0", "anywhere = 0.1"},
      {"coast = [-0.16", "coast = [-0.17"},
      {"roughness = 0.36", "roughness = 0.37"},
      {"temperature = \"temperature\"", "temperature = \"moisture\""},
      {"warmer = 0", "warmer = 0.1"},
      {"wetter = 0", "wetter = 0.1"},
      {"wavelength = 4600", "wavelength = 4601"},
      {"tributaries = 1900", "tributaries = 1901"},
      {"half_width = [13, 9]", "half_width = [13, 8]"},
      {"valley = [240, 130]", "valley = [241, 130]"},
      {"carve = [45, 26]", "carve = [45, 27]"},
      {"bed = 5.5", "bed = 5.6"},
      {"wavelength = 1400", "wavelength = 1401"},
      {"gain = 0.47", "gain = 0.48"},
  }));
  CAPTURE(from, to);
  CHECK(parsed(with(from, to)).fingerprint() != parsed(test::regions_world_text()).fingerprint());
}

TEST_CASE("An unused field changes nothing, at any position") {
  const std::string more = "[[field]]\nname = \"magic\"\nwavelength = 5000\noctaves = 2\ngain = 0.4\n";
  const World world = parsed(test::regions_world_text());
  CHECK(parsed(with("[[field]]", more + "[[field]]")).fingerprint() == world.fingerprint());
  CHECK(parsed(with("[surface]\n", more + "[surface]\n")).fingerprint() == world.fingerprint());
}

TEST_CASE("Every wrong key of regions is refused with file, line, key and what would be right") {
  const auto [from, to, message] = GENERATE(values<test::Wrong>({
      {"sea_level = 128", "", "sea_level: missing; land of regions is measured from the sea"},
      {"sea_level = 128", "sea_level = 100",
       "w.toml:3: sea_level: 100 is 100 voxels; a multiple of 64 is needed"},
      {"sea_level = 128", "sea_level = 0", "w.toml:3: sea_level: 0 is 0 voxels; a multiple of 64 is needed"},
      {"resolution = 1 ", "resolution = 65 ",
       "w.toml:2: resolution: 65 is out of range; 1 to 64 for regions"},
      {"strata_wavelength = 600", "", "strata_wavelength: missing"},
      {"name = \"ranges\"", "name = \"continents\"",
       "w.toml:13: field[1].name: 'continents' names another field already; names are unique"},
      {"name = \"ranges\"", "name = \".ranges\"", "w.toml:13: field[1].name: '.ranges' begins with a dot"},
      {"name = \"ranges\"", "name = \"\"", "w.toml:13: field[1].name: 1 to 64 bytes"},
      {"octaves = 7", "octaves = 9", "w.toml:9: field[0].octaves: 9 is out of range; 1 to 8"},
      {"wavelength = 9000", "wavelength = 4000",
       "w.toml:8: field[0].wavelength: 4000 is out of range; 4096 to 16777216 (4096 to 16777216 voxels"},
      {"wavelength = 9000", "", "field[0].wavelength: missing"},
      {"gain = 0.5", "gain = 0", "w.toml:10: field[0].gain: 0 is out of range; 0.001 to 1"},
      {"warp = 1", "warp = 2", "w.toml:11: field[0].warp: 2 is out of range; 0 to 1"},
      {"warp = 1", "wrap = 1", "w.toml:11: field[0].wrap: unknown key"},
      {"field = \"continents\"", "field = \"lands\"", "surface.land.field: no field is named 'lands'"},
      {"field = \"continents\"", "field = 3", "surface.land.field: 3 is an integer"},
      {"inland =", "inlands =", "surface.land.inlands: unknown key; known here: field, height, inland"},
      {"[[-0.5, 0.1], ", "[[-0.5, 1.1], ", "surface.land.inland[0]: y = 1.1 is out of range; 0 to 1"},
      {"[[-0.5, 0.1], ", "[[-3, 0.1], ", "surface.land.inland[0]: x = -3 is out of range; -2 to 2"},
      {"[[-0.5, 0.1], ", "[[-0.2, 0.1], ",
       "surface.land.inland[1]: x = -0.25 follows -0.2; each is at least"},
      {"[[-0.5, 0.1], ", "[[-0.5], ",
       "surface.land.inland[0]: is not a knot; a list of 1 to 12 knots [x, y]"},
      {"[[-0.5, 0.1], ", "[\"a\", ", "surface.land.inland[0]: is not a knot"},
      {"inland = [", "inland = 3 # [",
       "surface.land.inland: 3 is an integer; a list of 1 to 12 knots [x, y]"},
      {"inland = [", "inland = [] # [", "surface.land.inland: 0 knots; a list of 1 to 12 knots"},
      {"relief = 270", "relief = 40000", "surface.ranges.relief: 40000 is out of range; 0 to 32768"},
      {"relief = 270", "relief = 32000",
       "surface.kind: sea_level, land, ranges, hills and mesas come to 36295 voxels"},
      {"coast = [-0.16, 0.02]", "coast = [0.1, 0.1]", "surface.mesas.coast: 0.1 twice"},
      {"coast = [-0.16, 0.02]", "coast = [0.1, 0.1000000001]", "surface.mesas.coast: 0.1 twice, or nearly"},
      {"valley = [240, 130]", "valley = [3000, 130]",
       "surface.rivers.valley: 3000 is out of range; 0 to 700"},
      {"name = \"moisture\"", "name = \"height\"", "'height' is a quantity"},
      {"coast = [-0.16, 0.02]", "coast = [0.1]",
       "surface.mesas.coast: an array; a pair of numbers [a, b] is needed"},
      {"half_width = [13, 9]", "half_width = [0, 9]",
       "surface.rivers.half_width: 0 is out of range; 0.5 to 400"},
      {"valley = [240, 130]", "valley = [240, 15]", "surface.rivers.valley: 15 is narrower than its river"},
      {"bed = 5.5", "bed = nan", "surface.rivers.bed: nan is out of range"},
      {"[surface.shape]", "[surface.shapes]", "surface.shapes: unknown key; known here: land, ranges, hills"},
      {"kind = \"regions\"", "kind = \"perlin\"", "w.toml:6: field: is for surface.kind = \"regions\""},
      {"kind = \"regions\"", "kind = \"regions\"\namplitude = 3", "surface.amplitude: unknown key"},
  }));
  CAPTURE(from, to);
  CHECK_THAT(test::error_of(with(from, to)), Catch::Contains(message));
}

std::vector<ContentHash> chunks_of(const World& world, std::int64_t chunk_x, std::int64_t chunk_z, int tiles,
                                   int lod, std::int64_t of_x, std::int64_t of_z) {
  const int width = tiles * kChunkSize;
  const Stacks stacks =
      generate_stacks(world, {chunk_x * kChunkSize, chunk_z * kChunkSize, width, width, Lod::of(lod)});
  const auto x = static_cast<std::int32_t>(of_x);
  const auto z = static_cast<std::int32_t>(of_z);
  const MixedRange rows = mixed_range(world, stacks, x, z);
  std::vector<ContentHash> hashes;
  for (std::int32_t y = rows.first; y <= rows.last; ++y) {
    hashes.push_back(content_hash(extract_chunk(world, stacks, {x, y, z})));
  }
  return hashes;
}

TEST_CASE(
    "A chunk of regions is the same from whatever patch it is cut, at every level, at the world's ends, "
    "too") {
  const World world = parsed(test::regions_world_text());
  const std::int64_t end = std::int64_t{1} << 31;
  const auto [lod, x, z] = GENERATE_COPY(table<int, std::int64_t, std::int64_t>({
      {0, 0, 0},
      {0, -83, -150},
      {0, end - 2, -end},
      {1, -41, -75},
      {2, (end >> 2) - 2, 7},
      {3, -10, -18},
      {6, -2, -3},
      {6, (end >> 6) - 2, (end >> 6) - 2},
  }));
  CAPTURE(lod, x, z);
  const auto alone = chunks_of(world, x + 1, z + 1, 1, lod, x + 1, z + 1);
  CHECK(!alone.empty());
  CHECK(chunks_of(world, x, z, 2, lod, x + 1, z + 1) == alone);
}

}  // namespace
}  // namespace talus::terrain
