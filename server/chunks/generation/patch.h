// Patches: squares of tiles whose stacks are generated together, so that they share surface and halo. Their
// edge is a power of two of tiles: otherwise a patch would cross the world's end, where chunks' int32
// coordinates of one side would denote chunks of the other.
#pragma once

#include <bit>
#include <compare>
#include <cstdint>
#include <functional>

#include <talus/terrain/field.h>
#include <talus/voxel/coords.h>

namespace talus::server {

/// A patch, counted in patches of its level.
struct PatchKey {
  std::int32_t x = 0;
  std::int32_t z = 0;
  Lod lod;
  constexpr auto operator<=>(const PatchKey&) const = default;
};

/// Returns true if patches may have `tiles` tiles along each edge.
[[nodiscard]] constexpr bool is_patch_edge(int patch_tiles) {
  return patch_tiles > 0 && std::has_single_bit(static_cast<unsigned>(patch_tiles));
}

/// Returns the patch over which the chunk stands, of `patch_tiles` tiles along each edge.
[[nodiscard]] PatchKey patch_of(ChunkKey chunk, int patch_tiles);

/// Returns the patch's columns of voxels.
[[nodiscard]] terrain::Region region_of(const PatchKey& patch, int patch_tiles);

/// Returns the key that identifies a chunk's whole column of chunks.
[[nodiscard]] constexpr ChunkKey column_of(ChunkKey chunk) {
  return {{chunk.coord.x, 0, chunk.coord.z}, chunk.lod};
}

/// Calls visit(column_of(chunk)) for each column of chunks over the patch, x fastest.
template <typename Visit>
void for_each_column(const PatchKey& patch, int patch_tiles, Visit&& visit) {
  for (int z = 0; z < patch_tiles; ++z) {
    for (int x = 0; x < patch_tiles; ++x) {
      visit(ChunkKey{{patch.x * patch_tiles + x, 0, patch.z * patch_tiles + z}, patch.lod});
    }
  }
}

}  // namespace talus::server

template <>
struct std::hash<talus::server::PatchKey> {
  std::size_t operator()(const talus::server::PatchKey& key) const noexcept {
    return std::hash<talus::ChunkKey>{}({{key.x, 0, key.z}, key.lod});
  }
};
