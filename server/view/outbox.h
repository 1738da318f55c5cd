// What waits to be written to one client, in two queues: control frames go first and need no credit; chunks
// go while the client's credit lasts. Chunks are shared with the cache, not copied. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

#include <talus/protocol/message.h>
#include <talus/voxel/coords.h>

#include "chunks/encoded_chunk.h"
#include "view/credit.h"
#include "view/output.h"

namespace talus::server {

class Outbox {
 public:
  /// A chunk that waits for credit.
  struct Entry {
    std::uint32_t request_id = 0;  // 0: for the View
    ChunkKey key;
    EncodedChunkPtr chunk;
  };

  /// Bounds of one take(), beside the client's credit.
  struct TakeLimits {
    std::size_t enough_bytes = SIZE_MAX;  // of all frames; the last frame may pass it
    std::size_t chunks = SIZE_MAX;
    std::size_t chunk_bytes = SIZE_MAX;  // the last chunk may pass it
  };

  void push_control(protocol::Frame frame);
  void push_chunk(Entry&& entry);

  /// Removes the chunks for which `unwanted(entry)` returns true.
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

  /// Appends frames to `output` until a limit is reached or nothing is sendable.
  ///
  /// For each chunk, just before it is written, refresh(entry) may replace entry.chunk by a newer version, or
  /// return false: then the chunk is not written, and refresh has answered for it otherwise. For each chunk
  /// written, sent(entry) is called.
  template <typename Refresh, typename Sent>
  void take(const TakeLimits& limits, Credit& credit, Output& output, Refresh&& refresh, Sent&& sent) {
    take_control(limits.enough_bytes, output);
    std::size_t chunks = 0;
    const std::size_t control_bytes = output.size();
    while (!chunks_.empty() && output.size() < limits.enough_bytes && credit.may_send() &&
           chunks < limits.chunks && output.size() - control_bytes < limits.chunk_bytes) {
      Entry entry = std::move(chunks_.front());
      chunks_.pop_front();
      chunk_bytes_ -= cost(*entry.chunk);
      if (!refresh(entry)) continue;
      output.append(entry.chunk, entry.request_id, entry.key);
      credit.sent(entry.chunk->frame_bytes());
      ++chunks;
      sent(std::as_const(entry));
    }
    take_control(limits.enough_bytes, output);  // what refresh answered
  }

  /// Memory of the queued control frames.
  [[nodiscard]] std::size_t control_bytes() const { return control_bytes_; }
  /// Memory of the queued chunks, as if nobody else held them.
  [[nodiscard]] std::size_t chunk_bytes() const { return chunk_bytes_; }
  /// Roughly how much an output of all that waits would copy, by the chunks' mean size, when chunks of
  /// `shared_from` bytes and more are not copied.
  [[nodiscard]] std::size_t bytes_to_copy(std::size_t shared_from) const;
  /// What a waiting chunk adds to chunk_bytes().
  [[nodiscard]] static std::size_t cost(const EncodedChunk& chunk) { return sizeof(Entry) + chunk.bytes(); }

 private:
  void take_control(std::size_t enough_bytes, Output& output);

  std::deque<protocol::Frame> control_;
  std::deque<Entry> chunks_;
  std::size_t control_bytes_ = 0;
  std::size_t chunk_bytes_ = 0;
};

}  // namespace talus::server
