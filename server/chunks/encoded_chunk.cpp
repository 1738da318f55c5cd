#include "chunks/encoded_chunk.h"

#include <cassert>
#include <cstring>

#include <talus/voxel/codec.h>

namespace talus::server {
namespace {

constexpr std::uint32_t kAnyRequest = 1;  // not 0, which FlatBuffers would omit

protocol::Frame frame_of(ContentHash hash, std::span<const std::byte> payload, std::uint64_t revision) {
  constexpr std::size_t kEnvelopeBytes = 128;
  flatbuffers::FlatBufferBuilder builder{payload.size() + kEnvelopeBytes};
  const auto bytes =
      builder.CreateVector(reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size());
  const wire::ChunkKey anywhere;
  const wire::Hash128 wire_hash{hash.low, hash.high};
  const auto body =
      wire::CreateChunk(builder, kAnyRequest, &anywhere, revision, &wire_hash, kCodecVersion, bytes);
  return protocol::finish_frame(builder, body);
}

/// Offset of a field before the payload; these are few and of fixed size.
std::uint16_t distance(const protocol::Frame& frame, const void* inside) {
  return static_cast<std::uint16_t>(static_cast<const std::byte*>(inside) - frame.data());
}

}  // namespace

EncodedChunk::EncodedChunk(ContentHash hash, std::span<const std::byte> payload, std::uint64_t revision,
                           bool uniform)
    : hash_{hash}, revision_{revision}, uniform_{uniform}, frame_{frame_of(hash, payload, revision)} {
  const auto& chunk = *flatbuffers::GetSizePrefixedRoot<wire::Message>(frame_.data())->body_as_Chunk();
  id_at_ =
      distance(frame_, reinterpret_cast<const flatbuffers::Table&>(chunk).GetAddressOf(wire::Chunk::VT_ID));
  key_at_ = distance(frame_, chunk.key());
  // A FlatBuffer is built from its end, so the payload, created first, is last.
  head_bytes_ = distance(frame_, chunk.payload()->data());
  payload_bytes_ = chunk.payload()->size();
  assert(id_at_ < head_bytes_ && key_at_ < head_bytes_);
}

void EncodedChunk::append_frame(std::vector<std::byte>& output, std::uint32_t request_id,
                                ChunkKey key) const {
  append_first(frame_.size(), output, request_id, key);
}

void EncodedChunk::append_head(std::vector<std::byte>& output, std::uint32_t request_id, ChunkKey key) const {
  append_first(head_bytes_, output, request_id, key);
}

void EncodedChunk::append_first(std::size_t bytes, std::vector<std::byte>& output, std::uint32_t request_id,
                                ChunkKey key) const {
  output.insert(output.end(), frame_.begin(), frame_.begin() + static_cast<std::ptrdiff_t>(bytes));
  std::byte* const frame = &*(output.end() - static_cast<std::ptrdiff_t>(bytes));
  const wire::ChunkKey wire_key{key.coord.x, key.coord.y, key.coord.z,
                                static_cast<std::uint8_t>(key.lod.value())};
  const auto wire_id = flatbuffers::EndianScalar(request_id);
  std::memcpy(frame + id_at_, &wire_id, sizeof(wire_id));
  std::memcpy(frame + key_at_, &wire_key, sizeof(wire_key));
}

EncodedChunkPtr encode_shared(const Chunk& chunk, std::uint64_t revision) {
  thread_local std::vector<std::byte> payload;
  payload.clear();
  encode(chunk, payload);
  return std::make_shared<const EncodedChunk>(content_hash(chunk), payload, revision, chunk.is_uniform());
}

}  // namespace talus::server
