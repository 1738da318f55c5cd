#include "chunks/cache/chunk_cache.h"

#include <utility>

namespace talus::server {

void ChunkCache::put(ChunkKey key, EncodedChunkPtr chunk) {
  const std::size_t bytes = chunk->bytes();
  chunks_.put(key, std::move(chunk), bytes);
}

}  // namespace talus::server
