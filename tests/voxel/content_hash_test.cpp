#include <algorithm>

#include <rapidcheck.h>
#include <xxhash.h>
#include <catch2/catch.hpp>

#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>

#include "sample_chunks.h"

namespace talus {

using namespace testing;

TEST_CASE("the hash is XXH3-128 of the voxels as little-endian numbers") {
  CHECK(rc::check([] {
    const Chunk chunk = any_chunk();
    const auto voxels = voxels_of(chunk);
    std::vector<std::uint8_t> bytes;
    for (const MaterialId voxel : *voxels) {
      bytes.push_back(static_cast<std::uint8_t>(to_integer(voxel) & 0xFF));
      bytes.push_back(static_cast<std::uint8_t>(to_integer(voxel) >> 8));
    }
    const XXH128_hash_t expected = XXH3_128bits(bytes.data(), bytes.size());
    RC_ASSERT(content_hash(chunk) == (ContentHash{expected.low64, expected.high64}));
  }));
}

TEST_CASE("the hash depends on the voxels alone, not on their form") {
  CHECK(rc::check([] {
    const Chunk chunk = any_chunk();
    RC_ASSERT(content_hash(chunk) == content_hash(Chunk::from_dense(*voxels_of(chunk))));
    RC_ASSERT(content_hash(chunk) == content_hash(decode(encoded(chunk)).value()));
  }));
}

TEST_CASE("the hashes of known chunks are frozen") {
  CHECK(to_string(content_hash(Chunk::uniform(kAir))) == "fd5ee061c8433a0f33b202d302b65caa");
  CHECK(to_string(content_hash(Chunk::uniform(MaterialId{0x0102}))) == "3533bf07993fe34eb39b5fd32ad76877");
}

TEST_CASE("a hash prints its high half first") {
  CHECK(to_string(ContentHash{0x0123456789abcdef, 0xfedcba9876543210}) == "fedcba98765432100123456789abcdef");
}

}  // namespace talus
