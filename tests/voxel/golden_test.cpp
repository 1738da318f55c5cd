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
#include "payload_vectors.h"
#include "sample_chunks.h"

namespace talus {
namespace {

using namespace testing;

/// The bytes of one of FORMAT.md's worked examples.
std::vector<std::byte> worked_payload(const std::string& block) {
  std::istringstream digits{block_of(format_document(), block)};
  std::vector<std::byte> payload;
  unsigned value = 0;
  while (digits >> std::hex >> value) payload.push_back(static_cast<std::byte>(value));
  return payload;
}

/// `version`: of the payload, which is its first byte.
void check_frozen(int version, const std::string& name, const Chunk& chunk, const std::string& hash) {
  CAPTURE(name, version);
  const auto payload = frozen(version, name);
  CHECK(std::to_integer<int>(payload[0]) == version);
  const auto decoded = decode(payload);
  REQUIRE(decoded.has_value());
  CHECK(*decoded == chunk);
  CHECK(to_string(content_hash(*decoded)) == hash);
  CHECK(encoded(chunk) == payload);
}

}  // namespace

TEST_CASE("the worked examples in FORMAT.md are what the encoder writes") {
  for (const WorkedExample& example : worked_examples()) {
    CAPTURE(example.name);
    const auto payload = worked_payload("hex-" + example.name);
    CHECK(example.payload == payload);
    REQUIRE(decode(payload).has_value());
    CHECK(decode(payload).value() == example.chunk);
    CHECK(format_document().find(to_string(content_hash(example.chunk))) != std::string::npos);
  }
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

TEST_CASE("a decoder that follows FORMAT.md reads volumes, runs and raw voxels") {
  const std::string document = format_document();
  CHECK(rc::check([&document] {
    const Chunk chunk = Chunk::from_dense(*voxels_of(any_chunk()));
    RC_PRE(!chunk.is_uniform());
    const auto payload = encoded(chunk);
    RC_CLASSIFY(payload[1] == std::byte{1}, "volume");
    RC_CLASSIFY(payload[1] == std::byte{3}, "runs");
    const auto found = voxels_by_document(document, payload);
    const auto voxels = voxels_of(chunk);
    for (std::size_t i = 0; i < voxels->size(); ++i) RC_ASSERT(found[i] == to_integer((*voxels)[i]));
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

TEST_CASE("frozen volumes and runs") {
  for (const FrozenChunk& frozen_chunk : frozen_chunks()) {
    check_frozen(4, frozen_chunk.name, frozen_chunk.chunk, frozen_chunk.hash);
  }
}

}  // namespace talus
