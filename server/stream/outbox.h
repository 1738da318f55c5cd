// What waits to be written to one client: control frames, which go first and need no credit, and chunks,
// which go while the client's credit lasts. Chunks are shared with the cache, not copied. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include <talus/protocol/message.h>
#include <talus/voxel/coords.h>

#include "cache/encoded_chunk.h"
#include "stream/credit.h"

namespace talus::server {

/// How much of the chunk lane may be taken, beside what the client's credit allows; the last chunk may pass
/// `bytes`.
struct ChunkAllowance {
  std::size_t chunks = SIZE_MAX;
  std::size_t bytes = SIZE_MAX;
};

class Outbox {
 public:
  /// A chunk that waits for credit.
  struct Entry {
    std::uint32_t request_id = 0;  // 0: for the View
    ChunkKey key;
    EncodedChunkPtr chunk;
  };

  /// Frames to write at once, and the chunks that are among them.
  struct Taken {
    std::vector<protocol::Frame> frames;
    std::vector<Entry> chunks;
    std::size_t chunk_bytes = 0;  // of their frames
    std::size_t bytes = 0;        // of all frames
  };

  void push_control(protocol::Frame frame);
  void push_chunk(Entry entry);

  /// Removes the chunks for which `unwanted(entry)` holds.
  template <typename Unwanted>
  void drop_chunks(Unwanted&& unwanted) {
    std::erase_if(chunks_, [&](const Entry& entry) {
      const bool drop = unwanted(entry);
      if (drop) chunk_bytes_ -= cost(*entry.chunk);
      return drop;
    });
  }

  [[nodiscard]] bool sendable(const Credit& credit) const;
  [[nodiscard]] bool has_control() const { return !control_.empty(); }
  /// Takes frames until they have `enough_bytes` or nothing is sendable; the last may exceed it.
  [[nodiscard]] Taken take(std::size_t enough_bytes, Credit& credit, ChunkAllowance allowance = {});

  [[nodiscard]] std::size_t control_bytes() const { return control_bytes_; }
  /// Bytes of the chunks that wait, as if nobody else held them.
  [[nodiscard]] std::size_t chunk_bytes() const { return chunk_bytes_; }
  /// What a waiting chunk adds to chunk_bytes().
  [[nodiscard]] static std::size_t cost(const EncodedChunk& chunk);

 private:
  std::deque<protocol::Frame> control_;
  std::deque<Entry> chunks_;
  std::size_t control_bytes_ = 0;
  std::size_t chunk_bytes_ = 0;
};

}  // namespace talus::server
