// Encoded chunks in memory, bounded in bytes. Callable from any thread; a call locks one shard.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include <talus/voxel/coords.h>

#include "cache/encoded_chunk.h"
#include "cache/lru.h"

namespace talus::server {

class ChunkCache {
 public:
  static constexpr std::size_t kShards = 16;

  explicit ChunkCache(std::size_t capacity_bytes);

  /// Null where the chunk is not held.
  [[nodiscard]] EncodedChunkPtr find(ChunkKey key);
  void put(ChunkKey key, EncodedChunkPtr chunk);

  /// Bytes held now, overhead included; never more than the capacity.
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Shard {
    explicit Shard(std::size_t capacity_bytes) : chunks{capacity_bytes} {}
    mutable std::mutex mutex;
    Lru<ChunkKey, EncodedChunkPtr> chunks;
  };
  [[nodiscard]] Shard& shard_of(ChunkKey key);

  std::vector<std::unique_ptr<Shard>> shards_;
};

}  // namespace talus::server
