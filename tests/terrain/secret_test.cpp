#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/secret.h>

#include "features/sip_hash.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

SecretKey key_of(std::uint64_t seed) {
  return {{seed, ~seed, seed * 3, seed ^ 0x5555}};
}

// Ore in many cubes, with caves that cut it and cliffs that show it. `abundance` replaces all abundances.
World veined(std::uint64_t seed, const std::string& abundance = "0.7") {
  const std::string text = test::small_caves_text(seed) + test::underground_text();
  return World::parse(std::regex_replace(text, std::regex{"abundance = [0-9.]+"}, "abundance = " + abundance),
                      "veined")
      .value();
}

using Voxels = std::vector<MaterialId>;

Voxels voxels_of(const Chunk& chunk) {
  Voxels voxels(kChunkVolume);
  chunk.copy_to(std::span<MaterialId, kChunkVolume>{voxels});
  return voxels;
}

// Voxels of a world's level 0 by position.
class Voxel {
 public:
  explicit Voxel(const World& world) : world_{world} {}
  MaterialId at(VoxelPos at) {
    const ChunkKey key = chunk_holding(at, Lod{}).value();
    const auto [chunk, made] = chunks_.try_emplace(key.coord);
    if (made) chunk->second = voxels_of(generate_chunk(world_, key));
    return chunk->second[voxel_index(local_pos(at))];
  }

 private:
  const World& world_;
  std::map<ChunkCoord, Voxels> chunks_;
};

std::array<VoxelPos, 6> beside(VoxelPos at) {
  return {{{at.x - 1, at.y, at.z},
           {at.x + 1, at.y, at.z},
           {at.x, at.y - 1, at.z},
           {at.x, at.y + 1, at.z},
           {at.x, at.y, at.z - 1},
           {at.x, at.y, at.z + 1}}};
}

ChunkCoord any_chunk() {
  return {*rc::gen::inRange(-40, 40), *rc::gen::inRange(0, 3), *rc::gen::inRange(-40, 40)};
}

TEST_CASE("SipHash-2-4 gives its published vectors") {
  // Key 00 01 ... 0F, message 00 01 ...: the vectors of 0, 8, 16 and 24 bytes.
  SipHash hash{0x0706050403020100U, 0x0F0E0D0C0B0A0908U};
  CHECK(hash.value() == 0x726FDB47DD0E0E31U);
  hash = hash.with(0x0706050403020100U);
  CHECK(hash.value() == 0x93F5F5799A932462U);
  hash = hash.with(0x0F0E0D0C0B0A0908U);
  CHECK(hash.value() == 0x3F2ACC7F57C29BDBU);
  hash = hash.with(0x1716151413121110U);
  CHECK(hash.value() == 0xB8AD50C6F649AF94U);
}

TEST_CASE("A shown world has ore exactly where a face neighbour is air or water") {
  std::size_t shown_ore = 0;
  std::size_t hidden = 0;
  CHECK(rc::check([&] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const SecretKey key = key_of(*rc::gen::arbitrary<std::uint64_t>());
    const World world = veined(seed);
    const World barren = veined(seed, "0");
    const World full = world.with_secret_veins(key, SecretView::everything).value();
    const World shown = world.with_secret_veins(key).value();
    const ChunkCoord chunk = any_chunk();
    const Chunk made = generate_chunk(shown, {chunk, Lod{}});
    const Voxels of_full = voxels_of(generate_chunk(full, {chunk, Lod{}}));
    const Voxels of_shown = voxels_of(made);
    Voxel land{barren};
    std::vector<Override> expected_hidden;
    const VoxelPos origin = chunk_origin(chunk);
    for (std::uint16_t i = 0; i < kChunkVolume; ++i) {
      const LocalPos local = local_of(i);
      const VoxelPos at{origin.x + local.x, origin.y + local.y, origin.z + local.z};
      const MaterialId plain = land.at(at);
      const bool is_ore = of_full[i] != plain;
      const auto around = beside(at);
      const bool exposed = is_ore && std::any_of(around.begin(), around.end(), [&](VoxelPos each) {
                             const MaterialId other = land.at(each);
                             return other == kAir || other == kWater;
                           });
      RC_ASSERT(of_shown[i] == (exposed ? of_full[i] : plain));
      if (is_ore && !exposed) expected_hidden.push_back({i, of_full[i]});
      shown_ore += exposed ? 1 : 0;
    }
    hidden += expected_hidden.size();
    RC_ASSERT(hidden_ore(shown, chunk, made) == expected_hidden);
  }));
  CHECK(shown_ore > 100);
  CHECK(hidden > 1000);
}

TEST_CASE("Objects of a rock hide no ore") {
  std::string text = std::regex_replace(test::small_caves_text(9) + test::underground_text(),
                                        std::regex{"abundance = [0-9.]+"}, "abundance = 1");
  const World plain = World::parse(text, "plain").value();
  text +=
      "[[object]]\nname = \"stone\"\nmodel = \"boulder\"\nspacing = 6\nchance = 1\n"
      "stone = { name = \"basalt\" }\n";
  const World shown = World::parse(text, "stones").value().with_secret_veins(key_of(9)).value();
  Voxel ground{plain};
  std::size_t stones = 0;
  std::size_t hidden = 0;
  for (std::int32_t x = 0; x < 4; ++x) {
    for (std::int32_t y = 0; y < 3; ++y) {
      const ChunkCoord chunk{x, y, 2};
      const Chunk made = generate_chunk(shown, {chunk, Lod{}});
      const auto stands = [&](LocalPos at) {
        const VoxelPos origin = chunk_origin(chunk);
        const MaterialId before = ground.at({origin.x + at.x, origin.y + at.y, origin.z + at.z});
        return made.at(at) != kAir && before == kAir;
      };
      for (std::size_t i = 0; i < kChunkVolume; ++i) stones += stands(local_of(i)) ? 1 : 0;
      for (const Override& ore : hidden_ore(shown, chunk, made)) {
        CHECK_FALSE(stands(local_of(ore.index)));
        ++hidden;
      }
    }
  }
  CHECK(stones > 100);
  CHECK(hidden > 100);
}

TEST_CASE("Chunks of a shown world do not depend on their patch") {
  CHECK(rc::check([] {
    const World shown = veined(*rc::gen::arbitrary<std::uint64_t>())
                            .with_secret_veins(key_of(*rc::gen::arbitrary<int>()))
                            .value();
    const ChunkCoord chunk = any_chunk();
    const VoxelPos origin = chunk_origin(chunk);
    const auto west = *rc::gen::inRange(0, 3);
    const auto north = *rc::gen::inRange(0, 3);
    const Region patch{origin.x - kChunkSize * west, origin.z - kChunkSize * north, 3 * kChunkSize,
                       3 * kChunkSize, Lod{}};
    const Stacks stacks = generate_stacks(shown, region_of_stacks(shown, patch));
    RC_ASSERT(extract_chunk(shown, stacks, chunk) == generate_chunk(shown, {chunk, Lod{}}));
    RC_ASSERT(mixed_range(shown, stacks, chunk.x, chunk.z).first <=
              mixed_range(shown, stacks, chunk.x, chunk.z).last + 1);
  }));
}

TEST_CASE("Chunks outside of the mixed rows of a shown world are uniform") {
  const World shown = veined(11).with_secret_veins(key_of(11)).value();
  for (std::int32_t x = 0; x < 6; ++x) {
    const Region tile{std::int64_t{x} * kChunkSize, 0, kChunkSize, kChunkSize, Lod{}};
    const Stacks stacks = generate_stacks(shown, region_of_stacks(shown, tile));
    const MixedRange rows = mixed_range(shown, stacks, x, 0);
    for (const std::int32_t y : {rows.first - 1, rows.last + 1}) {
      CHECK(extract_chunk(shown, stacks, {x, y, 0}) == Chunk::uniform(y < rows.first ? rows.below : kAir));
    }
  }
}

TEST_CASE("Coarse levels of a shown world have no ore") {
  for (int level = 1; level < 4; ++level) {
    const World world = veined(7);
    const World shown = world.with_secret_veins(key_of(7)).value();
    for (std::int32_t x = 0; x < 4; ++x) {
      const ChunkKey key{{x, 0, 1}, Lod::of(level)};
      CHECK(generate_chunk(shown, key) == generate_chunk(veined(7, "0"), key));
    }
  }
}

TEST_CASE("The ore of maps at level 0 is ore that chunks show") {
  const World shown = veined(5).with_secret_veins(key_of(5)).value();
  const Region region{0, 0, 64, 64, Lod{}};
  const Stacks stacks = generate_stacks(shown, region_of_stacks(shown, region));
  const std::vector<MaterialId> exposed = exposed_overlays(shown, stacks);
  Voxel voxels{shown};
  std::size_t seen = 0;
  for (int z = 1; z < 65; ++z) {
    for (int x = 1; x < 65; ++x) {
      const MaterialId ore = exposed[static_cast<std::size_t>(z * 66 + x)];
      const bool is_bare = stacks.rock_top().at(x, z) == stacks.tops.back().at(x, z);
      if (ore == kAir || !is_bare || stacks.is_entrance(x, z)) continue;
      const std::int64_t row = (stacks.rock_top().at(x, z) + 127) / kSubvoxels - 1;
      CHECK(voxels.at({x - 1, row, z - 1}) == ore);
      ++seen;
    }
  }
  CHECK(seen > 0);
}

TEST_CASE("Key and spec both decide the secret ore and the fingerprint") {
  const World world = veined(3);
  const World one = world.with_secret_veins(key_of(1), SecretView::everything).value();
  const World same = world.with_secret_veins(key_of(1), SecretView::everything).value();
  const World other_key = world.with_secret_veins(key_of(2), SecretView::everything).value();
  CHECK(one.fingerprint() == same.fingerprint());
  CHECK(std::set{world.fingerprint(), one.fingerprint(), other_key.fingerprint(),
                 veined(4).with_secret_veins(key_of(1)).value().fingerprint()}
            .size() == 4);
  const ChunkKey key{{1, 1, 1}, Lod{}};
  CHECK(generate_chunk(one, key) == generate_chunk(same, key));
  CHECK(generate_chunk(one, key) != generate_chunk(other_key, key));
  CHECK(generate_chunk(one, key) != generate_chunk(world, key));
  // The half that draws tells nothing of the half that names, and neither decides the other's part.
  SecretKey renamed = key_of(1);
  renamed.words[3] += 1;
  const World again = world.with_secret_veins(renamed, SecretView::everything).value();
  CHECK(again.fingerprint() != one.fingerprint());
  CHECK(generate_chunk(again, key) == generate_chunk(one, key));
}

TEST_CASE("A world without veins has no secrets") {
  CHECK_FALSE(test::small_world(1).with_secret_veins(key_of(1)).has_value());
  const World world = veined(1);
  CHECK_FALSE(world.has_secrets());
  CHECK(hidden_ore(world, {}, generate_chunk(world, {})).empty());
}

}  // namespace
}  // namespace talus::terrain
