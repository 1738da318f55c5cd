// Decoded generated chunks of level 0, to look up single voxels. For one thread.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

#include "chunks/cache/clock_cache.h"
#include "chunks/encoded_chunk.h"

namespace talus::server {

using DecodedChunkPtr = std::shared_ptr<const Chunk>;

class DecodedBases {
 public:
  /// Keeps about `capacity_bytes` of recently used chunks.
  explicit DecodedBases(std::size_t capacity_bytes)
      : capacity_bytes_{capacity_bytes}, chunks_{capacity_bytes} {}

  /// Changes the capacity, and evicts what exceeds it.
  void set_capacity(std::size_t bytes);
  [[nodiscard]] std::size_t bytes() const { return chunks_.bytes(); }

  /// Null if it is not kept.
  [[nodiscard]] DecodedChunkPtr find(ChunkCoord chunk);
  /// Decodes and keeps it. Throws std::runtime_error if it does not decode, which only a bug can cause.
  DecodedChunkPtr put(ChunkCoord chunk, const EncodedChunk& encoded);

 private:
  std::size_t capacity_bytes_;
  ClockCache<ChunkKey, DecodedChunkPtr> chunks_;
};

/// The voxels at `indices`, which are ascending.
[[nodiscard]] std::vector<Override> voxels_at(const Chunk& chunk, std::span<const std::uint16_t> indices);

}  // namespace talus::server
