// A cache of encoded chunks in memory, bounded in bytes. Callable from any thread; a call locks one shard.
#pragma once

#include <cstddef>

#include <talus/voxel/coords.h>

#include "chunks/cache/sharded_cache.h"
#include "chunks/encoded_chunk.h"

namespace talus::server {

class ChunkCache {
 public:
  explicit ChunkCache(std::size_t capacity_bytes) : chunks_{capacity_bytes} {}

  /// Null if the chunk is not cached.
  [[nodiscard]] EncodedChunkPtr find(ChunkKey key) { return chunks_.find(key).value_or(nullptr); }
  /// Does not count as a use.
  [[nodiscard]] bool holds(ChunkKey key) { return chunks_.holds(key); }
  void put(ChunkKey key, EncodedChunkPtr chunk);

  /// The same as in ShardedCache.
  void set_capacity(std::size_t capacity_bytes) { chunks_.set_capacity(capacity_bytes); }
  [[nodiscard]] bool fit(std::size_t& probes) { return chunks_.fit(probes); }
  [[nodiscard]] std::size_t bytes() const { return chunks_.bytes(); }

 private:
  ShardedCache<ChunkKey, EncodedChunkPtr> chunks_;
};

}  // namespace talus::server
