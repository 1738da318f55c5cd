// A chunk as it goes out: shared by the cache and by every session that sends it.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <talus/voxel/chunk.h>
#include <talus/voxel/content_hash.h>

namespace talus::server {

struct EncodedChunk {
  ContentHash hash;
  std::vector<std::byte> payload;  // of codec kCodecVersion
};
using EncodedChunkPtr = std::shared_ptr<const EncodedChunk>;

[[nodiscard]] EncodedChunkPtr encode_shared(const Chunk& chunk);

}  // namespace talus::server
