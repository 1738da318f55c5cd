// What one write carries: frames, one after the other.
//
// Small ones are copied into one piece of memory, as the system takes one piece faster than many. Of large
// chunks only the beginning is copied, where request and place stand, and the rest is written from where the
// cache has it.
#pragma once

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

  /// Frames of `shared_from` bytes and more are not copied.
  explicit Output(std::size_t shared_from = kCopyAll) : shared_from_{shared_from} {}

  void reserve(std::size_t bytes) { copied_.reserve(bytes); }
  void append(std::span<const std::byte> frame);
  /// `request_id` 0: sent for the View. The chunk lives as long as this does, where it is not copied.
  void append(const EncodedChunkPtr& chunk, std::uint32_t request_id, ChunkKey key);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Of memory in order; they point into this.
  [[nodiscard]] std::vector<std::span<const std::byte>> pieces() const;

 private:
  struct Shared {
    std::size_t after;  // so many copied bytes
    EncodedChunkPtr chunk;
  };

  std::size_t shared_from_;
  std::size_t size_ = 0;
  std::vector<std::byte> copied_;
  std::vector<Shared> shared_;
};

}  // namespace talus::server
