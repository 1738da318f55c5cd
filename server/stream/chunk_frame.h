// A Chunk message as a frame.
#pragma once

#include <cstdint>

#include <talus/protocol/message.h>
#include <talus/voxel/coords.h>

#include "cache/encoded_chunk.h"

namespace talus::server {

/// `request_id` 0: sent for the View.
[[nodiscard]] protocol::Frame chunk_frame(std::uint32_t request_id, ChunkKey key, const EncodedChunk& chunk);

}  // namespace talus::server
