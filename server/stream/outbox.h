// What waits to be written to one client: control frames, which go first and need no credit, and chunks,
// which go while the client's credit lasts. Chunks are shared with the cache, not copied. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include <talus/protocol/message.h>
#include <talus/voxel/coords.h>

#include "chunks/encoded_chunk.h"
#include "stream/credit.h"
#include "stream/output.h"

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
  /// Appends frames to `output` until it has `enough_bytes` or nothing is sendable or allowed; the last may
  /// exceed it. Calls sent(entry, frame_bytes) for each chunk among them.
  template <typename Sent>
  void take(std::size_t enough_bytes, Credit& credit, ChunkAllowance allowance, Output& output, Sent&& sent) {
    take_control(enough_bytes, output);
    std::size_t chunks = 0;
    const std::size_t control_bytes = output.size();
    while (!chunks_.empty() && output.size() < enough_bytes && credit.may_send() &&
           chunks < allowance.chunks && output.size() - control_bytes < allowance.bytes) {
      const Entry entry = std::move(chunks_.front());
      chunks_.pop_front();
      chunk_bytes_ -= cost(*entry.chunk);
      output.append(entry.chunk, entry.request_id, entry.key);
      credit.sent(entry.chunk->frame_bytes());
      ++chunks;
      sent(entry, entry.chunk->frame_bytes());
    }
  }

  [[nodiscard]] std::size_t control_bytes() const { return control_bytes_; }
  /// Bytes of the chunks that wait, as if nobody else held them.
  [[nodiscard]] std::size_t chunk_bytes() const { return chunk_bytes_; }
  /// About what an output of all that waits would copy, if it shares chunks of `shared_from` bytes and more:
  /// by their mean size.
  [[nodiscard]] std::size_t bytes_to_copy(std::size_t shared_from) const;
  /// What a waiting chunk adds to chunk_bytes().
  [[nodiscard]] static std::size_t cost(const EncodedChunk& chunk);

 private:
  void take_control(std::size_t enough_bytes, Output& output);

  std::deque<protocol::Frame> control_;
  std::deque<Entry> chunks_;
  std::size_t control_bytes_ = 0;
  std::size_t chunk_bytes_ = 0;
};

}  // namespace talus::server
