// Frozen payloads: stored chunks and other people's decoders rely on these bytes. They change only
// together with kCodecVersion.
#include <algorithm>
#include <sstream>
#include <string>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>

#include "format_decoder.h"
#include "sample_chunks.h"

namespace talus {
namespace {

using namespace testing;

std::vector<std::byte> worked_payload() {
  std::istringstream digits{block_of(format_document(), "hex")};
  std::vector<std::byte> payload;
  unsigned value = 0;
  while (digits >> std::hex >> value) payload.push_back(static_cast<std::byte>(value));
  return payload;
}

/// FORMAT.md's worked example: sloping rock, soil of two rows that ends in the south, air.
Chunk worked_example() {
  Layers layers{{MaterialId{2}, MaterialId{300}, kAir}, {}};
  layers.tops.resize(2 * kChunkArea);
  for (int z = 0; z < kChunkSize; ++z) {
    for (int x = 0; x < kChunkSize; ++x) {
      const int rock = 10 + x / 8;
      layers.tops[column_index(x, z)] = static_cast<std::uint8_t>(rock);
      layers.tops[kChunkArea + column_index(x, z)] = static_cast<std::uint8_t>(z < 20 ? rock + 2 : rock);
    }
  }
  return Chunk::from_layers(std::move(layers));
}

/// `version`: of the payload, which is its first byte.
void check_decodes(int version, const std::string& name, const Chunk& chunk, const std::string& hash) {
  CAPTURE(name, version);
  const auto payload = frozen(version, name);
  CHECK(std::to_integer<int>(payload[0]) == version);
  const auto decoded = decode(payload);
  REQUIRE(decoded.has_value());
  CHECK(*decoded == chunk);
  CHECK(to_string(content_hash(*decoded)) == hash);
}

void check_frozen(int version, const std::string& name, const Chunk& chunk, const std::string& hash) {
  check_decodes(version, name, chunk, hash);
  CHECK(encoded(chunk) == frozen(version, name));
}

/// A house of random bricks on a hill.
Chunk house() {
  std::vector<Override> bricks;
  for (std::uint8_t y = 20; y < 26; ++y) {
    for (std::uint8_t z = 8; z < 17; ++z) {
      for (std::uint8_t x = 5; x < 18; ++x) {
        const bool wall = y == 25 || z == 8 || z == 16 || x == 5 || x == 17;
        const auto brick = static_cast<std::uint16_t>((x * 7 + y * 13 + z * 5) % 11 == 0 ? 301 : 300);
        bricks.push_back(
            {static_cast<std::uint16_t>(voxel_index({x, y, z})), wall ? MaterialId{brick} : kAir});
      }
    }
  }
  return Chunk::from_layers(hill(1)).with_overrides(bricks);
}

}  // namespace

TEST_CASE("the worked example in FORMAT.md is what encode gives") {
  const auto payload = worked_payload();
  CHECK(encoded(worked_example()) == payload);
  CHECK(decode(payload).value() == worked_example());
}

TEST_CASE("FORMAT.md names the hash of its worked example") {
  CHECK(format_document().find(to_string(content_hash(worked_example()))) != std::string::npos);
}

TEST_CASE("a decoder that follows FORMAT.md reads what encode writes") {
  const std::string document = format_document();
  CHECK(rc::check([&document](std::uint64_t seed) {
    const auto planes = *rc::gen::inRange<std::size_t>(0, 40).as("planes");
    const int smoothness = *rc::gen::inRange(0, 64).as("smoothness");
    const int kind = *rc::gen::inRange(0, 3).as("a hill, random or leaping");
    Layers layers = kind == 0   ? hill(seed)
                    : kind == 1 ? random_layers(seed, planes, smoothness)
                                : leaping_layers(seed, planes);
    if (*rc::gen::arbitrary<bool>().as("large ids")) layers = with_large_ids(std::move(layers));
    const Chunk chunk = Chunk::from_layers(std::move(layers));
    const auto payload = encoded(chunk);
    RC_PRE(payload[1] == std::byte{0});
    const Layers found = decode_by_document(document, payload);
    RC_ASSERT(found.materials == chunk.layers()->materials);
    RC_ASSERT(found.tops == chunk.layers()->tops);
  }));
}

TEST_CASE("a frozen uniform chunk") {
  check_frozen(3, "uniform", Chunk::uniform(MaterialId{300}), "8fd40e1b20c8f07877ffa3ca1005ef6d");
}

TEST_CASE("frozen layers") {
  check_frozen(3, "hill", Chunk::from_layers(hill(1)), "86a412f7635065ddd535272aa6357d00");
  check_frozen(3, "rough", Chunk::from_layers(random_layers(3, 5, 100)), "73a0fbf0dede1e7e49092591490760f0");
  // So many materials are not told by how the states end.
  check_frozen(3, "listed", Chunk::from_layers(with_large_ids(random_layers(3, 7, 400))),
               "582b5749ecf6907e51316a5e6bddaaa0");
}

TEST_CASE("frozen palettes of version 3 are still read") {
  check_decodes(3, "few_materials", Chunk::from_dense(*random_voxels(4, 3, 400)),
                "0564daf8667aa83423445a05545e3b08");
  check_decodes(3, "many_materials", Chunk::from_dense(*random_voxels(5, 250, 900)),
                "0ed79e2ad7c1f106b448eb03bdc4b1af");
}

TEST_CASE("frozen volumes") {
  check_frozen(4, "house", house(), "@HOUSE@");
  check_frozen(4, "sloping", Chunk::from_dense(*voxels_of(Chunk::from_layers(hill(1)))),
               "86a412f7635065ddd535272aa6357d00");
}

TEST_CASE("frozen runs") {
  check_frozen(4, "few_materials", Chunk::from_dense(*random_voxels(4, 3, 40)), "@RUNS@");
  check_frozen(4, "many_materials", Chunk::from_dense(*random_voxels(5, 250, 90)), "@MANY@");
}

}  // namespace talus
