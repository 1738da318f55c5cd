// Patches: squares of tiles whose stacks are generated together, so that they share surface and halo.
#pragma once

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

/// The patch, `patch_tiles` tiles along each edge, over which the chunk stands.
[[nodiscard]] PatchKey patch_of(ChunkKey chunk, int patch_tiles);

/// Its columns.
[[nodiscard]] terrain::Region region_of(const PatchKey& patch, int patch_tiles);

}  // namespace talus::server

template <>
struct std::hash<talus::server::PatchKey> {
  std::size_t operator()(const talus::server::PatchKey& key) const noexcept {
    return std::hash<talus::ChunkKey>{}({{key.x, 0, key.z}, key.lod});
  }
};
