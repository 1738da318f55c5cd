// Chunks through the C interface have the golden voxels.
#include <talus_local.h>

#include <xxhash.h>

#include <cstdint>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/voxel/content_hash.h>

#include "golden_worlds.h"

using namespace talus;
using namespace talus::test;

namespace {

/// The golden hash of the voxels of a world's place, as tests/golden/golden.cpp makes it, by chunks of the
/// library. Which rows it covers is core/terrain's.
std::string hash_of(const terrain::World& world, talus_workspace* workspace, const Place& place) {
  const int width = place.tiles * kChunkSize;
  const terrain::Stacks stacks = terrain::generate_stacks(
      world, {place.chunk_x * kChunkSize, place.chunk_z * kChunkSize, width, width, Lod::of(place.lod)});
  std::vector<talus_chunk_key> keys;
  for (int tz = 0; tz < place.tiles; ++tz) {
    for (int tx = 0; tx < place.tiles; ++tx) {
      const auto x = static_cast<std::int32_t>(place.chunk_x + tx);
      const auto z = static_cast<std::int32_t>(place.chunk_z + tz);
      const terrain::MixedRange rows = terrain::mixed_range(world, stacks, x, z);
      for (std::int32_t y = rows.first - 1; y <= rows.last + 1; ++y) {
        keys.push_back({x, y, z, static_cast<std::uint32_t>(place.lod)});
      }
    }
  }
  std::vector<std::uint16_t> voxels(keys.size() * TALUS_CHUNK_VOLUME);
  const talus_status made = talus_generate(workspace, keys.data(), keys.size(), 0, voxels.data(), nullptr);
  INFO(talus_local_error());
  REQUIRE(made == TALUS_OK);
  std::vector<std::uint64_t> hashes;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const XXH128_hash_t hash = XXH3_128bits(voxels.data() + i * TALUS_CHUNK_VOLUME, TALUS_CHUNK_VOLUME * 2);
    hashes.insert(hashes.end(), {hash.low64, hash.high64});
  }
  const XXH128_hash_t digest = XXH3_128bits(hashes.data(), hashes.size() * sizeof(std::uint64_t));
  return to_string(ContentHash{digest.low64, digest.high64});
}

}  // namespace

TEST_CASE("chunks of the C interface have the golden voxels") {
  std::ifstream golden{TALUS_SOURCE_DIR "/tests/golden/golden.txt"};
  std::string line;
  std::getline(golden, line);
  int compared = 0;
  const std::set<std::string> chosen{"classic", "features", "warped", "underground", "default", "mesas"};
  for (const auto& [name, spec, more] : kWorlds) {
    std::getline(golden, line);
    CHECK(line.starts_with(name));
    talus_local_world* world = nullptr;
    talus_workspace* workspace = nullptr;
    const std::string toml = more + read_file(std::string{TALUS_SOURCE_DIR} + "/" + spec + ".toml");
    if (chosen.contains(name)) {
      talus_world_options options{};
      options.size = sizeof options;
      options.toml = toml.c_str();
      options.toml_bytes = toml.size();
      REQUIRE(talus_world_open(&options, &world) == TALUS_OK);
      REQUIRE(talus_workspace_create(world, 0, &workspace) == TALUS_OK);
    }
    for (const Place& place : kPlaces) {
      std::getline(golden, line);
      if (world == nullptr) continue;
      INFO(name << ", " << place.what);
      const auto own = terrain::World::parse(toml, name);
      REQUIRE(own);
      CHECK_THAT(line, Catch::Contains("voxels " + hash_of(*own, workspace, place) + " "));
      ++compared;
    }
    talus_workspace_destroy(workspace);
    talus_world_close(world);
  }
  CHECK(compared == 60);
}
