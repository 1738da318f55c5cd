// A chunk as it goes out: a whole Chunk message, made once, shared by the cache and by every session that
// sends it. Only the request and the place in it differ from one sending to the next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <talus/protocol/message.h>
#include <talus/voxel/chunk.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>

namespace talus::server {

class EncodedChunk {
 public:
  /// `payload` is of codec kCodecVersion.
  EncodedChunk(ContentHash hash, std::span<const std::byte> payload, std::uint64_t revision = 0);

  [[nodiscard]] ContentHash hash() const { return hash_; }
  /// 0: as generated; a later version of the same chunk has a larger one.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] std::size_t frame_bytes() const { return frame_.size(); }
  /// What it occupies, for whoever accounts for it.
  [[nodiscard]] std::size_t bytes() const { return sizeof(EncodedChunk) + frame_.capacity(); }

  /// Appends the frame. `request_id` 0: sent for the View.
  void append_frame(std::vector<std::byte>& output, std::uint32_t request_id, ChunkKey key) const;
  /// The frame in two: its head, in which request and place stand, and its tail, the payload, as it lies
  /// here.
  void append_head(std::vector<std::byte>& output, std::uint32_t request_id, ChunkKey key) const;
  [[nodiscard]] std::span<const std::byte> tail() const { return std::span{frame_}.subspan(head_bytes_); }
  /// Has the processor fetch the frame's beginning while the caller goes on.
  void prefetch() const { __builtin_prefetch(frame_.data()); }

 private:
  void append_first(std::size_t bytes, std::vector<std::byte>& output, std::uint32_t request_id,
                    ChunkKey key) const;

  ContentHash hash_;
  std::uint64_t revision_ = 0;
  std::uint32_t id_at_ = 0;  // where in the frame
  std::uint32_t key_at_ = 0;
  std::uint32_t head_bytes_ = 0;
  protocol::Frame frame_;
};
using EncodedChunkPtr = std::shared_ptr<const EncodedChunk>;

/// Each thread keeps the memory in which the payload is made.
[[nodiscard]] EncodedChunkPtr encode_shared(const Chunk& chunk);

}  // namespace talus::server
