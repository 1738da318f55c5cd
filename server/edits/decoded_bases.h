// Chunks of level 0 as generated, decoded, for who looks up single voxels of them. For one thread.
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
  /// Keeps about so many bytes of those used last.
  explicit DecodedBases(std::size_t capacity_bytes)
      : capacity_bytes_{capacity_bytes}, chunks_{capacity_bytes} {}

  /// Keeps no more than so many from now on, and gives back what is too much.
  void set_capacity(std::size_t bytes);
  [[nodiscard]] std::size_t bytes() const { return chunks_.bytes(); }

  /// Null where it is not kept.
  [[nodiscard]] DecodedChunkPtr find(ChunkCoord chunk);
  /// Decodes and keeps it. Throws std::runtime_error where it does not decode, which only a fault can cause.
  DecodedChunkPtr put(ChunkCoord chunk, const EncodedChunk& encoded);

 private:
  std::size_t capacity_bytes_;
  ClockCache<ChunkKey, DecodedChunkPtr> chunks_;
};

/// The voxels at `indices`, which rise.
[[nodiscard]] std::vector<Override> voxels_at(const Chunk& chunk, std::span<const std::uint16_t> indices);

}  // namespace talus::server
