// The frames of one write.
//
// Small frames are copied into one buffer, because the kernel takes one buffer faster than many. Of a large
// chunk only the head, with request id and key, is copied; its payload is written from the cache's memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/voxel/coords.h>

#include "chunks/encoded_chunk.h"

namespace talus::server {

class Output {
 public:
  static constexpr std::size_t kCopyAll = SIZE_MAX;

  /// Frames of at least `shared_from` bytes are not copied.
  explicit Output(std::size_t shared_from = kCopyAll);
  /// Each thread keeps the memory of a few outputs for reuse: writes follow one another, each of a few KiB,
  /// which an allocator would split and merge every time.
  ~Output();
  Output(Output&&) noexcept = default;
  Output& operator=(Output&&) = delete;

  void reserve(std::size_t bytes) { copied_.reserve(bytes); }
  void append(std::span<const std::byte> frame);
  /// `request_id` 0: sent for the View. A chunk that is not copied is kept alive by this object.
  void append(const EncodedChunkPtr& chunk, std::uint32_t request_id, ChunkKey key);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Memory that it holds: its frames, or the capacity of its copy buffer if that is more.
  [[nodiscard]] std::size_t held_bytes() const { return std::max(size_, copied_.capacity()); }
  /// The buffers to write, in order; they point into this object.
  [[nodiscard]] std::vector<std::span<const std::byte>> pieces() const;

 private:
  struct SharedChunk {
    std::size_t after;  // copied bytes that precede it
    EncodedChunkPtr chunk;
  };

  std::size_t shared_from_;
  std::size_t size_ = 0;
  std::vector<std::byte> copied_;
  std::vector<SharedChunk> shared_;
};

}  // namespace talus::server
