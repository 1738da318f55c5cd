#include <talus/voxel/content_hash.h>

#include <array>
#include <bit>
#include <memory>
#include <string_view>

#include <xxhash.h>

namespace talus {

ContentHash content_hash(const Chunk& chunk) {
  static_assert(std::endian::native == std::endian::little,
                "voxels are hashed as they lie in memory; a big-endian machine must swap their bytes first");
  const auto voxels = std::make_unique_for_overwrite<DenseVoxels>();
  chunk.copy_to(*voxels);
  const XXH128_hash_t hash = XXH3_128bits(voxels->data(), sizeof(DenseVoxels));
  return {hash.low64, hash.high64};
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
