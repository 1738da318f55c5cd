// A chunk as received from a server: decoded, and checked against its hash.
#pragma once

#include <cstdint>
#include <memory>

#include <talus/voxel/chunk.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>

namespace talus::client {

struct ReceivedChunk {
  ChunkKey key;
  std::uint64_t revision = 0;          // 0: as generated; increases with each change
  ContentHash hash;                    // of the voxels
  std::shared_ptr<const Chunk> chunk;  // null: unchanged since the hash passed to get() as `known`
  [[nodiscard]] bool unchanged() const { return chunk == nullptr; }
};

}  // namespace talus::client
