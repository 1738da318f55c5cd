#include "cache/chunk_cache.h"

#include <utility>

#include <talus/voxel/codec.h>

namespace talus::server {

EncodedChunkPtr encode_shared(const Chunk& chunk) {
  auto encoded = std::make_shared<EncodedChunk>();
  encoded->hash = content_hash(chunk);
  encode(chunk, encoded->payload);
  encoded->payload.shrink_to_fit();
  return encoded;
}

ChunkCache::ChunkCache(std::size_t capacity_bytes) {
  shards_.reserve(kShards);
  for (std::size_t shard = 0; shard < kShards; ++shard) {
    shards_.push_back(std::make_unique<Shard>(capacity_bytes / kShards));
  }
}

EncodedChunkPtr ChunkCache::find(ChunkKey key) {
  Shard& shard = shard_of(key);
  const std::lock_guard lock{shard.mutex};
  const EncodedChunkPtr* chunk = shard.chunks.find(key);
  return chunk == nullptr ? nullptr : *chunk;
}

void ChunkCache::put(ChunkKey key, EncodedChunkPtr chunk) {
  const std::size_t bytes = sizeof(EncodedChunk) + chunk->payload.capacity();
  Shard& shard = shard_of(key);
  const std::lock_guard lock{shard.mutex};
  shard.chunks.put(key, std::move(chunk), bytes);
}

std::size_t ChunkCache::bytes() const {
  std::size_t sum = 0;
  for (const auto& shard : shards_) {
    const std::lock_guard lock{shard->mutex};
    sum += shard->chunks.bytes();
  }
  return sum;
}

ChunkCache::Shard& ChunkCache::shard_of(ChunkKey key) {
  // The map inside the shard uses the low bits of the same hash.
  return *shards_[(std::hash<ChunkKey>{}(key) >> 40) % kShards];
}

}  // namespace talus::server
