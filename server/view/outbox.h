// What waits to be written to one client. Control frames go first and need no credit. Then updates go, of
// chunks that the client holds and that were edited since, and then chunks, both while the client's credit
// lasts: chunks from two lanes, those of requests and those of the View, which share by bytes: a deficit
// round robin of two flows whose quantum is one chunk. Chunks are shared with the cache, not copied. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
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

  enum class Lane : std::uint8_t { requests, view };

  /// Bounds of one take(), beside the client's credit.
  struct TakeLimits {
    std::size_t enough_bytes = SIZE_MAX;  // of all frames; the last frame may pass it
    std::size_t chunks = SIZE_MAX;
    std::size_t chunk_bytes = SIZE_MAX;  // the last chunk may pass it
  };

  /// What goes for an update: a frame, a whole chunk of the View, or, where both are empty, nothing.
  struct Update {
    protocol::Frame frame{};
    EncodedChunkPtr chunk{};
  };

  struct Taken {
    std::size_t chunks = 0;
    std::size_t chunk_bytes = 0;  // of their frames
  };

  void push_control(protocol::Frame frame);
  /// The chunk is not among the updates already.
  void push_update(ChunkKey key) { updates_.push_back(key); }
  void push_chunk(Entry&& entry);

  /// Removes the chunks for which `unwanted(entry)` returns true. Returns how many.
  template <typename Unwanted>
  std::size_t drop_chunks(Unwanted&& unwanted) {
    std::size_t dropped = 0;
    for (Queue* const queue : {&requests_, &view_}) {
      dropped += std::erase_if(queue->entries, [&](const Entry& entry) {
        const bool drop = unwanted(entry);
        if (drop) queue->bytes -= cost(*entry.chunk);
        return drop;
      });
    }
    return dropped;
  }

  /// Likewise of updates.
  template <typename Unwanted>
  void drop_updates(Unwanted&& unwanted) {
    std::erase_if(updates_, std::forward<Unwanted>(unwanted));
  }

  [[nodiscard]] bool sendable(const Credit& credit) const;
  [[nodiscard]] bool has_control() const { return !control_.empty(); }

  /// Appends frames to `output` until a limit is reached or nothing is sendable. Also where both lanes had
  /// chunks and that whose turn it is has none left: the caller fills it again before the other goes on.
  ///
  /// For each chunk that leaves write(entry) is called, which may replace entry.chunk by a newer version, or
  /// returns a frame that goes in its place. For each update that leaves write_update(key) returns what goes;
  /// it may push the same update again, for the next take().
  template <typename Write, typename WriteUpdate>
  Taken take(const TakeLimits& limits, Credit& credit, Output& output, Write&& write,
             WriteUpdate&& write_update) {
    take_control(limits.enough_bytes, output);
    Taken taken;
    const std::size_t control_bytes = output.size();
    const auto may_go = [&] {
      return output.size() < limits.enough_bytes && credit.may_send() && taken.chunks < limits.chunks &&
             output.size() - control_bytes < limits.chunk_bytes;
    };
    const auto append = [&](const EncodedChunkPtr& chunk, std::uint32_t request_id, ChunkKey key) {
      output.append(chunk, request_id, key);
      credit.sent(chunk->frame_bytes());
      ++taken.chunks;
      taken.chunk_bytes += chunk->frame_bytes();
      return chunk->frame_bytes();
    };
    for (std::size_t left = updates_.size(); left > 0 && may_go(); --left) {
      const ChunkKey key = updates_.front();
      updates_.pop_front();
      const Update update = write_update(key);
      if (update.chunk != nullptr) {
        append(update.chunk, 0, key);
      } else {
        output.append(update.frame);
      }
    }
    const auto send_first = [&](Queue& queue) -> std::size_t {
      Entry entry = std::move(queue.entries.front());
      queue.entries.pop_front();
      queue.bytes -= cost(*entry.chunk);
      if (const std::optional<protocol::Frame> instead = write(entry)) {
        output.append(*instead);
        return instead->size();
      }
      return append(entry.chunk, entry.request_id, entry.key);
    };
    if (requests_.entries.empty() || view_.entries.empty()) {
      requests_ahead_ = 0;  // what one was sent while the other wanted nothing is no debt
      Queue& only = view_.entries.empty() ? requests_ : view_;
      while (!only.entries.empty() && may_go()) (void)send_first(only);
    } else {
      while (may_go()) {
        const bool view_turn = requests_ahead_ > 0;
        Queue& turn = view_turn ? view_ : requests_;
        if (turn.entries.empty()) break;
        const auto bytes = static_cast<std::ptrdiff_t>(send_first(turn));
        requests_ahead_ += view_turn ? -bytes : bytes;
      }
    }
    return taken;
  }

  /// Memory of the queued control frames.
  [[nodiscard]] std::size_t control_bytes() const { return control_bytes_; }
  /// Updates that wait.
  [[nodiscard]] std::size_t updates() const { return updates_.size(); }
  /// Memory of the queued chunks, as if nobody else held them.
  [[nodiscard]] std::size_t chunk_bytes() const { return requests_.bytes + view_.bytes; }
  [[nodiscard]] std::size_t chunk_bytes(Lane lane) const { return queue(lane).bytes; }
  [[nodiscard]] std::size_t chunks(Lane lane) const { return queue(lane).entries.size(); }
  /// Roughly how much an output of all that waits would copy, by the chunks' mean size, when chunks of
  /// `shared_from` bytes and more are not copied.
  [[nodiscard]] std::size_t bytes_to_copy(std::size_t shared_from) const;
  /// What a waiting chunk adds to chunk_bytes().
  [[nodiscard]] static std::size_t cost(const EncodedChunk& chunk) { return sizeof(Entry) + chunk.bytes(); }

 private:
  struct Queue {
    std::deque<Entry> entries;
    std::size_t bytes = 0;
  };
  [[nodiscard]] const Queue& queue(Lane lane) const { return lane == Lane::view ? view_ : requests_; }
  void take_control(std::size_t enough_bytes, Output& output);

  std::deque<protocol::Frame> control_;
  std::deque<ChunkKey> updates_;
  Queue requests_;
  Queue view_;
  std::size_t control_bytes_ = 0;
  // Bytes that requests were sent more than the View since both have chunks: within one chunk of 0.
  std::ptrdiff_t requests_ahead_ = 0;
};

}  // namespace talus::server
