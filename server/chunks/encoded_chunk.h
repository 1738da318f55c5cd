// The wire form of a chunk: a whole Chunk message, made once and shared by the cache and all sessions that
// send it. Only the request id and the key differ each time; they are patched into a copy.
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

/// Revision of generated chunks. Every edit of a chunk has a larger one.
inline constexpr std::uint64_t kBaseRevision = 0;

/// The version of a chunk that a client wants: as generated, or with its edits.
enum class Version : std::uint8_t { generated, edited };

/// Immutable, so any thread may read it.
class EncodedChunk {
 public:
  /// `payload` is readable by a session with codec kCodecVersion: its first byte is that version, or an older
  /// one that the codec includes. The frame's `codec` is the session's, kCodecVersion.
  EncodedChunk(ContentHash hash, std::span<const std::byte> payload, std::uint64_t revision = kBaseRevision,
               bool uniform = false);

  /// Hash of the voxels, independent of their encoding.
  [[nodiscard]] ContentHash hash() const { return hash_; }
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// True if all voxels have the same material. The frame is then smaller than most messages.
  [[nodiscard]] bool uniform() const { return uniform_; }
  /// The exact payload, as FORMAT.md defines it; lives as long as this object.
  [[nodiscard]] std::span<const std::byte> payload() const { return tail().first(payload_bytes_); }
  [[nodiscard]] std::size_t frame_bytes() const { return frame_.size(); }
  /// Memory of this object, itself included.
  [[nodiscard]] std::size_t bytes() const { return sizeof(EncodedChunk) + frame_.capacity(); }

  /// Appends the frame. `request_id` 0: sent for the View.
  void append_frame(std::vector<std::byte>& output, std::uint32_t request_id, ChunkKey key) const;
  /// Appends the frame up to its payload, with everything that differs each time. tail() follows.
  void append_head(std::vector<std::byte>& output, std::uint32_t request_id, ChunkKey key) const;
  /// The rest of the frame: the payload and FlatBuffers' padding.
  [[nodiscard]] std::span<const std::byte> tail() const { return std::span{frame_}.subspan(head_bytes_); }

  /// Prefetches the first kPrefetchBytes of the frame into the CPU cache. The processor fetches the rest by
  /// itself as the frame is copied; so a large frame displaces nothing.
  void prefetch() const {
    constexpr std::size_t kLineBytes = 64;
    const std::size_t end = frame_.size() < kPrefetchBytes ? frame_.size() : kPrefetchBytes;
    for (std::size_t at = 0; at < end; at += kLineBytes) __builtin_prefetch(frame_.data() + at);
  }
  static constexpr std::size_t kPrefetchBytes = 256;

 private:
  void append_first(std::size_t bytes, std::vector<std::byte>& output, std::uint32_t request_id,
                    ChunkKey key) const;

  ContentHash hash_;
  std::uint64_t revision_;
  // Offsets into the frame.
  std::uint16_t id_at_ = 0;
  std::uint16_t key_at_ = 0;
  std::uint16_t head_bytes_ = 0;
  bool uniform_;
  std::uint32_t payload_bytes_ = 0;
  protocol::Frame frame_;
};
using EncodedChunkPtr = std::shared_ptr<const EncodedChunk>;

/// Each thread reuses its encoding buffer.
[[nodiscard]] EncodedChunkPtr encode_shared(const Chunk& chunk, std::uint64_t revision = kBaseRevision);

}  // namespace talus::server
