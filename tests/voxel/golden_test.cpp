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

void check_frozen(const std::string& name, const Chunk& chunk, const std::string& hash) {
  for (int version = kOldestCodecVersion; version <= kCodecVersion; ++version) {
    CAPTURE(name, version);
    const auto decoded = decode(frozen(version, name));
    REQUIRE(decoded.has_value());
    CHECK(*decoded == chunk);
    CHECK(to_string(content_hash(*decoded)) == hash);
  }
  CHECK(encoded(chunk) == frozen(kCodecVersion, name));
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
  check_frozen("uniform", Chunk::uniform(MaterialId{300}), "8fd40e1b20c8f07877ffa3ca1005ef6d");
}

TEST_CASE("frozen layers") {
  check_frozen("hill", Chunk::from_layers(hill(1)), "86a412f7635065ddd535272aa6357d00");
  check_frozen("rough", Chunk::from_layers(random_layers(3, 5, 100)), "73a0fbf0dede1e7e49092591490760f0");
  // So many materials are not told by how the states end.
  check_frozen("listed", Chunk::from_layers(with_large_ids(random_layers(3, 7, 400))),
               "582b5749ecf6907e51316a5e6bddaaa0");
}

TEST_CASE("frozen palettes") {
  check_frozen("few_materials", Chunk::from_dense(*random_voxels(4, 3, 400)),
               "0564daf8667aa83423445a05545e3b08");
  check_frozen("many_materials", Chunk::from_dense(*random_voxels(5, 250, 900)),
               "0ed79e2ad7c1f106b448eb03bdc4b1af");
}

}  // namespace talus
