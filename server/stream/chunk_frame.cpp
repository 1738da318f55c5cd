#include "stream/chunk_frame.h"

#include <talus/voxel/codec.h>

namespace talus::server {

protocol::Frame chunk_frame(std::uint32_t request_id, ChunkKey key, const EncodedChunk& chunk) {
  constexpr std::size_t kEnvelopeBytes = 128;
  flatbuffers::FlatBufferBuilder builder{chunk.payload.size() + kEnvelopeBytes};
  const auto payload =
      builder.CreateVector(reinterpret_cast<const std::uint8_t*>(chunk.payload.data()), chunk.payload.size());
  const wire::ChunkKey wire_key{key.coord.x, key.coord.y, key.coord.z,
                                static_cast<std::uint8_t>(key.lod.value())};
  const wire::Hash128 hash{chunk.hash.low, chunk.hash.high};
  const auto body = wire::CreateChunk(builder, request_id, &wire_key, 0, &hash, kCodecVersion, payload);
  return protocol::finish_frame(builder, body);
}

}  // namespace talus::server
