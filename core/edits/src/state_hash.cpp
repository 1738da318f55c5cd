#include <talus/edits/state_hash.h>

#include <array>
#include <cstddef>

#include <xxhash.h>

#include <talus/voxel/content_hash.h>

namespace talus::edits {
namespace {

StateHash hash_of(ChunkCoord chunk, Override voxel) {
  std::array<std::uint8_t, 16> bytes;
  std::size_t at = 0;
  const auto put = [&](std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes[at++] = static_cast<std::uint8_t>(value >> (8 * i));
  };
  put(static_cast<std::uint32_t>(chunk.x), 4);
  put(static_cast<std::uint32_t>(chunk.y), 4);
  put(static_cast<std::uint32_t>(chunk.z), 4);
  put(voxel.index, 2);
  put(to_integer(voxel.material), 2);
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return {hash.low64, hash.high64};
}

}  // namespace

void StateHash::add(ChunkCoord chunk, Override voxel) {
  const StateHash more = hash_of(chunk, voxel);
  low += more.low;
  high += more.high + (low < more.low ? 1 : 0);
}

void StateHash::remove(ChunkCoord chunk, Override voxel) {
  const StateHash less = hash_of(chunk, voxel);
  high -= less.high + (low < less.low ? 1 : 0);
  low -= less.low;
}

void StateHash::add(ChunkCoord chunk, std::span<const Override> voxels) {
  for (const Override& voxel : voxels) add(chunk, voxel);
}

std::string to_string(StateHash hash) {
  return to_string(ContentHash{hash.low, hash.high});
}

}  // namespace talus::edits
