#include <talus/voxel/content_hash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

// Allows the streaming hash state on the stack.
#define XXH_STATIC_LINKING_ONLY
#include <xxhash.h>
#if defined(__x86_64__) && __has_include(<xxh_x86dispatch.h>)
#include <xxh_x86dispatch.h>  // the same functions in the vectors of the machine it runs on
#endif

#include <talus/vectors/little_endian.h>

#include "slices.h"

namespace talus {
namespace {

ContentHash from(XXH128_hash_t hash) {
  return {hash.low64, hash.high64};
}

}  // namespace

ContentHash content_hash(const Chunk& chunk) {
  const DenseVoxels* const voxels = chunk.dense();
  if (std::endian::native == std::endian::little && voxels != nullptr) {
    return from(XXH3_128bits(voxels->data(), sizeof(DenseVoxels)));
  }
  // Layers are hashed slice by slice: dense voxels would exceed the nearest cache.
  XXH3_state_t state;
  XXH3_128bits_reset(&state);
  std::array<MaterialId, kChunkArea> slice;
  std::vector<std::byte> scratch;
  const auto update = [&] {
    const auto bytes = little_endian_bytes(std::span<const MaterialId>{slice}, scratch);
    XXH3_128bits_update(&state, bytes.data(), bytes.size());
  };
  if (voxels != nullptr) {
    for (auto from_voxel = voxels->begin(); from_voxel != voxels->end(); from_voxel += kChunkArea) {
      std::copy_n(from_voxel, kChunkArea, slice.begin());
      update();
    }
    return from(XXH3_128bits_digest(&state));
  }
  Slices slices{chunk.base() != nullptr ? *chunk.base() : *chunk.layers()};
  auto changed = chunk.overrides().begin();
  for (std::size_t first = 0; first < kChunkVolume; first += kChunkArea) {
    slices.next(slice.data());
    for (; changed != chunk.overrides().end() && changed->index < first + kChunkArea; ++changed) {
      slice[changed->index - first] = changed->material;
    }
    update();
  }
  return from(XXH3_128bits_digest(&state));
}

std::string to_string(ContentHash hash) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  text.reserve(32);
  for (const std::uint64_t half : {hash.high, hash.low}) {
    for (int shift = 60; shift >= 0; shift -= 4) text.push_back(kDigits[(half >> shift) & 15U]);
  }
  return text;
}

}  // namespace talus
