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

void ChunkCache::put(ChunkKey key, EncodedChunkPtr chunk) {
  const std::size_t bytes = sizeof(EncodedChunk) + chunk->payload.capacity();
  chunks_.put(key, std::move(chunk), bytes);
}

}  // namespace talus::server
