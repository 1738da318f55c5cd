#include <algorithm>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/voxel/codec.h>

#include "sample_chunks.h"

namespace talus {
namespace {

using namespace testing;

enum Encoding : int { kLayered = 0x300, kVolume = 0x401, kRaw = 0x402, kRuns = 0x403 };

/// The first two bytes of its payload.
int encoding_of(const Chunk& chunk) {
  const auto payload = encoded(chunk);
  return std::to_integer<int>(payload[0]) << 8 | std::to_integer<int>(payload[1]);
}

}  // namespace

TEST_CASE("a chunk comes back from its payload") {
  CHECK(rc::check([] {
    const Chunk chunk = any_chunk();
    const auto back = decode(encoded(chunk));
    RC_ASSERT(back.has_value());
    RC_ASSERT(*back == chunk);
  }));
}

TEST_CASE("no payload is larger than raw voxels and two bytes") {
  CHECK(rc::check([] { RC_ASSERT(encoded(any_chunk()).size() <= kMaxPayloadBytes); }));
}

TEST_CASE("past 1 KiB layers never cost more than the same voxels without them") {
  CHECK(rc::check([] {
    const Chunk chunk = any_chunk();
    const std::size_t dense_bytes = encoded(Chunk::from_dense(*voxels_of(chunk))).size();
    RC_ASSERT(encoded(chunk).size() <= std::max<std::size_t>(1024, dense_bytes));
  }));
}

TEST_CASE("a layered payload gives layers") {
  CHECK(rc::check([](std::uint64_t seed) {
    const Chunk chunk = Chunk::from_layers(hill(seed));
    RC_ASSERT(encoding_of(chunk) == kLayered);
    const auto back = decode(encoded(chunk));
    RC_ASSERT(back.has_value());
    RC_ASSERT(back->layers() != nullptr);
    RC_ASSERT(back->layers()->materials == chunk.layers()->materials);
    RC_ASSERT(back->layers()->tops == chunk.layers()->tops);
  }));
}

TEST_CASE("materials whose ids take up to sixteen bytes are distinguished by the end of the states") {
  // Nine materials, of ids of one byte or of two.
  for (std::size_t large = 0; large <= 8; ++large) {
    Layers layers;
    for (std::size_t m = 0; m < 9; ++m) {
      layers.materials.push_back(MaterialId{static_cast<std::uint16_t>(m + (m < large ? 200 : 1))});
      if (m > 0) layers.tops.insert(layers.tops.end(), kChunkArea, static_cast<std::uint8_t>(3 * m));
    }
    const auto payload = encoded(Chunk::from_layers(layers));
    CAPTURE(large);
    CHECK(std::to_integer<int>(payload[2]) == (9 + large <= 16 ? 64 + 9 : 9));
    REQUIRE(decode(payload).has_value());
    CHECK(decode(payload)->layers()->materials == layers.materials);
  }
}

TEST_CASE("a step from one end to the other and back comes back") {
  for (const auto& [first, second] : {std::pair{32, 32}, {32, 2}, {2, 32}, {32, 0}}) {
    Layers pillars{{MaterialId{3}, kAir}, std::vector<std::uint8_t>(kChunkArea)};
    pillars.tops[column_index(10, 5)] = static_cast<std::uint8_t>(first);
    pillars.tops[column_index(11, 6)] = static_cast<std::uint8_t>(second);
    const Chunk chunk = Chunk::from_layers(pillars);
    REQUIRE(decode(encoded(chunk)).has_value());
    CHECK(*decode(encoded(chunk)) == chunk);
  }
}

TEST_CASE("overrides are written as their voxels are") {
  CHECK(rc::check([](std::uint64_t seed) {
    const Chunk chunk = with_random_overrides(Chunk::from_layers(hill(seed)), seed);
    RC_ASSERT(chunk.base() != nullptr);
    RC_ASSERT(encoded(chunk) == encoded(Chunk::from_dense(*voxels_of(chunk))));
    RC_ASSERT(decode(encoded(chunk)).value() == chunk);
  }));
}

TEST_CASE("encode appends") {
  std::vector<std::byte> out{std::byte{1}, std::byte{2}};
  const Chunk chunk = Chunk::from_layers(hill(1));
  encode(chunk, out);
  const std::vector<std::byte> tail(out.begin() + 2, out.end());
  CHECK(out[0] == std::byte{1});
  CHECK(out[1] == std::byte{2});
  CHECK(tail == encoded(chunk));
}

TEST_CASE("a uniform chunk is a handful of bytes") {
  CHECK(encoded(Chunk::uniform(kAir)).size() == 4);
  CHECK(encoded(Chunk::uniform(MaterialId{0xFFFF})).size() == 6);
}

TEST_CASE("each encoding has chunks for which it is the smallest") {
  CHECK(encoding_of(Chunk::from_layers(hill(3))) == kLayered);
  CHECK(encoding_of(Chunk::from_dense(*voxels_of(Chunk::from_layers(hill(3))))) == kVolume);
  CHECK(encoding_of(Chunk::from_dense(*random_voxels(3, 4, 20))) == kRuns);
  CHECK(encoding_of(Chunk::from_dense(*random_voxels(3, 30000, 1))) == kRaw);
}

TEST_CASE("large layers go by runs where these are smaller") {
  // Two materials by turns, each column changing at rows of its own: the planes are noise.
  const auto noise = random_voxels(7, 2, 1);
  Layers turns{{kAir}, {}};
  for (std::size_t p = 0; p < kChunkSize; ++p) turns.materials.push_back(p % 2 == 0 ? MaterialId{9} : kAir);
  turns.tops.assign(turns.plane_count() * kChunkArea, kChunkSize);
  for (std::size_t column = 0; column < kChunkArea; ++column) {
    std::size_t plane = 0;
    for (std::size_t y = 0; y < kChunkSize; ++y) {
      const bool is_air = to_integer((*noise)[y * kChunkArea + column]) == 0;
      if (is_air == (plane % 2 == 0)) continue;
      turns.tops[plane * kChunkArea + column] = static_cast<std::uint8_t>(y);
      ++plane;
    }
  }
  const Chunk chunk = Chunk::from_layers(turns);
  REQUIRE(chunk.layers() != nullptr);
  CHECK(encoding_of(chunk) != kLayered);
  CHECK(decode(encoded(chunk)).value() == chunk);
}

TEST_CASE("256 materials can be coded, 257 are written raw") {
  const auto voxels = std::make_unique<DenseVoxels>();
  const auto cycle = [&voxels](std::size_t materials) {
    for (std::size_t i = 0; i < voxels->size(); ++i) {
      (*voxels)[i] = MaterialId{static_cast<std::uint16_t>(i % materials)};
    }
    return Chunk::from_dense(*voxels);
  };
  CHECK(encoding_of(cycle(256)) != kRaw);
  CHECK(encoding_of(cycle(257)) == kRaw);
  CHECK(decode(encoded(cycle(256))).value() == cycle(256));
  CHECK(decode(encoded(cycle(257))).value() == cycle(257));
}

}  // namespace talus
