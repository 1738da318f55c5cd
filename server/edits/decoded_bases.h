// Decoded generated chunks of level 0, to look up single voxels. For one thread.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

#include "chunks/cache/clock_cache.h"
#include "chunks/encoded_chunk.h"

namespace talus::server {

struct DecodedBase {
  Chunk chunk;
  std::vector<Override> hidden;  // secret materials that it does not show, by ascending index
};
using DecodedBasePtr = std::shared_ptr<const DecodedBase>;

class DecodedBases {
 public:
  /// Returns the secret materials of a chunk as generated; null: there are none.
  using Hidden = std::function<std::vector<Override>(ChunkCoord, const Chunk&)>;

  /// Keeps about `capacity_bytes` of recently used chunks.
  explicit DecodedBases(std::size_t capacity_bytes, Hidden hidden = {})
      : capacity_bytes_{capacity_bytes}, hidden_{std::move(hidden)}, chunks_{capacity_bytes} {}

  /// Changes the capacity, and evicts what exceeds it.
  void set_capacity(std::size_t bytes);
  [[nodiscard]] std::size_t bytes() const { return chunks_.bytes(); }

  /// Null if it is not kept.
  [[nodiscard]] DecodedBasePtr find(ChunkCoord chunk);
  /// Decodes and keeps it. Throws std::runtime_error if it does not decode, which only a bug can cause.
  DecodedBasePtr put(ChunkCoord chunk, const EncodedChunk& encoded);

 private:
  std::size_t capacity_bytes_;
  Hidden hidden_;
  ClockCache<ChunkKey, DecodedBasePtr> chunks_;
};

/// Those of `voxels` that are at `indices`; both are ascending.
[[nodiscard]] std::vector<Override> among(std::span<const Override> voxels,
                                          std::span<const std::uint16_t> indices);
/// The voxels at `indices`, which are ascending.
[[nodiscard]] std::vector<Override> voxels_at(const Chunk& chunk, std::span<const std::uint16_t> indices);

}  // namespace talus::server
