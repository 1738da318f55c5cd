#include <talus/edits/state_hash.h>

#include <algorithm>

#include <rapidcheck.h>
#include <xxhash.h>
#include <catch2/catch.hpp>

namespace talus::edits {
namespace {

struct AddedOverride {
  ChunkCoord chunk;
  Override voxel;
};

std::vector<AddedOverride> any_overrides() {
  std::vector<AddedOverride> all;
  for (int left = *rc::gen::inRange(0, 40); left > 0; --left) {
    const auto coordinate = [] { return *rc::gen::element<std::int32_t>(INT32_MIN, -1, 0, 1, INT32_MAX); };
    const auto index = *rc::gen::inRange<std::uint16_t>(0, kChunkVolume);
    all.push_back({{coordinate(), coordinate(), coordinate()},
                   {index, MaterialId{*rc::gen::arbitrary<std::uint16_t>()}}});
  }
  return all;
}

}  // namespace

TEST_CASE("the hash of an override is XXH3-128 of the 16 bytes of FORMAT.md") {
  StateHash hash;
  CHECK(to_string(hash) == "00000000000000000000000000000000");
  hash.add({1, -2, 0x01020304}, {0x7FFE, MaterialId{0x0A0B}});
  const unsigned char bytes[] = {1, 0, 0, 0, 0xFE, 0xFF, 0xFF, 0xFF, 4, 3, 2, 1, 0xFE, 0x7F, 0x0B, 0x0A};
  const XXH128_hash_t expected = XXH3_128bits(bytes, sizeof(bytes));
  CHECK(hash == StateHash{expected.low64, expected.high64});
  CHECK(to_string(hash) == "5f0c2ab20d283228d2dc06460658367e");
}

TEST_CASE("S is the sum modulo 2^128, in any order") {
  CHECK(rc::check([] {
    auto all = any_overrides();
    __extension__ using Wide = unsigned __int128;
    Wide sum = 0;
    StateHash hash;
    for (const AddedOverride& each : all) {
      StateHash one;
      one.add(each.chunk, each.voxel);
      sum += (Wide{one.high} << 64) + one.low;
      hash.add(each.chunk, each.voxel);
    }
    RC_ASSERT(hash.low == static_cast<std::uint64_t>(sum));
    RC_ASSERT(hash.high == static_cast<std::uint64_t>(sum >> 64));
    std::reverse(all.begin(), all.end());
    StateHash backwards;
    for (const AddedOverride& each : all) backwards.add(each.chunk, each.voxel);
    RC_ASSERT(backwards == hash);
  }));
}

TEST_CASE("an added chunk can be removed, first or last") {
  CHECK(rc::check([] {
    const auto all = any_overrides();
    StateHash hash;
    for (const AddedOverride& each : all) hash.add(each.chunk, each.voxel);
    StateHash rest;
    for (std::size_t i = all.size() / 2; i < all.size(); ++i) rest.add(all[i].chunk, all[i].voxel);
    for (std::size_t i = 0; i < all.size() / 2; ++i) hash.remove(all[i].chunk, all[i].voxel);
    RC_ASSERT(hash == rest);
    for (std::size_t i = all.size() / 2; i < all.size(); ++i) hash.remove(all[i].chunk, all[i].voxel);
    RC_ASSERT(hash == StateHash{});
  }));
}

}  // namespace talus::edits
