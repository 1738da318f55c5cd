// The frames, chunks and updates that wait to be written to one client. Control frames go first and need no
// credit. While the client's credit lasts two pairs of flows take turns by bytes: updates of chunks that the
// client holds and that were edited since (broadcasts, and chunks that are sent again), and chunks (for
// requests, and for the View). So nothing that others do to the land keeps a client's View from coming.
// Chunks are shared with the cache, not copied. No I/O.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

#include <talus/protocol/message.h>
#include <talus/voxel/coords.h>

#include "chunks/encoded_chunk.h"
#include "limits/flows/fair_queue.h"
#include "player/view/credit.h"
#include "player/view/output.h"

namespace talus::server {

class Outbox {
 public:
  class Write;

  /// A chunk that waits for credit.
  struct Entry {
    std::uint32_t request_id = 0;  // 0: for the View
    ChunkKey key;
    EncodedChunkPtr chunk;
  };

  enum class Lane : std::uint8_t { requests, view };

  /// Limits of one write, in addition to the client's credit.
  struct WriteLimits {
    std::size_t enough_bytes = SIZE_MAX;  // of all frames; the last frame may exceed it
    std::size_t chunks = SIZE_MAX;
    std::size_t chunk_bytes = SIZE_MAX;  // the last chunk may exceed it
  };

  void push_control(protocol::Frame frame);
  /// REQUIRES: the chunk is not among the updates.
  void push_update(ChunkKey key) { updates_.push_back(key); }
  /// An update that took its turn goes as the whole chunk, in another turn.
  void push_resend(ChunkKey key) { resends_.push_back(key); }
  void push_chunk(Entry&& entry);
  /// Of the View's chunks, those for which `goes_first(key)` returns true go before the others, in the order
  /// in which they came.
  template <typename GoesFirst>
  void move_first(GoesFirst&& goes_first) {
    std::ranges::stable_partition(view_.entries, goes_first, &Entry::key);
  }

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

  /// Removes the updates for which `unwanted(key)` returns true.
  template <typename Unwanted>
  void drop_updates(Unwanted&& unwanted) {
    std::erase_if(updates_, unwanted);
    std::erase_if(resends_, unwanted);
  }

  [[nodiscard]] bool sendable(const Credit& credit) const;
  [[nodiscard]] bool has_control() const { return !control_.empty(); }

  /// Memory of the queued control frames.
  [[nodiscard]] std::size_t control_bytes() const { return control_bytes_; }
  /// Number of queued updates.
  [[nodiscard]] std::size_t updates() const { return updates_.size() + resends_.size(); }
  /// Memory of the queued chunks, as if nothing else held them.
  [[nodiscard]] std::size_t chunk_bytes() const { return requests_.bytes + view_.bytes; }
  [[nodiscard]] std::size_t chunk_bytes(Lane lane) const { return queue(lane).bytes; }
  [[nodiscard]] std::size_t chunks(Lane lane) const { return queue(lane).entries.size(); }
  /// Estimates the bytes that an output of the whole queue would copy, by the chunks' mean size, if chunks of
  /// `shared_from` bytes and more are not copied.
  [[nodiscard]] std::size_t bytes_to_copy(std::size_t shared_from) const;
  /// Bytes that a queued chunk adds to chunk_bytes().
  [[nodiscard]] static std::size_t cost(const EncodedChunk& chunk) { return sizeof(Entry) + chunk.bytes(); }

 private:
  struct Queue {
    std::deque<Entry> entries;
    std::size_t bytes = 0;
  };
  enum class Pair : std::uint8_t { updates, chunks };
  /// One of the two flows of a pair.
  enum class Flow : std::uint8_t { broadcasts = 0, resends = 1, requests = 0, view = 1 };
  /// Broadcasts are small and wanted at once: they may be this many bytes ahead of their share.
  static constexpr double kBroadcastsAhead = 16 * 1024;

  void wait(Pair pair, Flow flow, bool waits) {
    if (!waits) return turns_.leave(pair, flow);
    const bool ahead = pair == Pair::updates && flow == Flow::broadcasts;
    turns_.enter({.offset = ahead ? -kBroadcastsAhead : 0}, pair, flow);
  }
  [[nodiscard]] const Queue& queue(Lane lane) const { return lane == Lane::view ? view_ : requests_; }
  void take_control(std::size_t enough_bytes, Output& output);

  std::deque<protocol::Frame> control_;
  std::deque<ChunkKey> updates_;  // not known yet to need the whole chunk
  std::deque<ChunkKey> resends_;  // updates that go as the whole chunk
  Queue requests_;
  Queue view_;
  std::size_t control_bytes_ = 0;
  FairQueue<Classes<Pair, 2>, Classes<Flow, 2>> turns_;
};

/// One write to the client: control frames, then updates and chunks in turns. The caller calls next() until
/// it returns Turn::none; in each turn it takes the chunk or the update that goes next, and appends at most
/// one chunk or frame for it.
class Outbox::Write {
 public:
  enum class Turn : std::uint8_t { none, broadcasts, resends, requests, view };

  /// Appends the control frames to `output`. All outlive this.
  Write(Outbox& outbox, const WriteLimits& limits, Credit& credit, Output& output);

  /// Returns the next turn; Turn::none if a limit is reached or nothing is sendable. Also
  /// if it is the turn of a lane that had chunks and has none left: the caller fills it before the other lane
  /// goes on. Updates pushed during the write wait for the next one.
  [[nodiscard]] Turn next();

  /// In Turn::broadcasts.
  [[nodiscard]] ChunkKey take_update();
  /// In Turn::resends.
  [[nodiscard]] ChunkKey take_resend();
  /// In Turn::requests or Turn::view.
  [[nodiscard]] Entry take_chunk();

  /// `request_id` 0: for the View.
  void append(const EncodedChunkPtr& chunk, std::uint32_t request_id, ChunkKey key);
  void append(const protocol::Frame& frame) { output_.append(frame); }

  /// Number of appended chunks.
  [[nodiscard]] std::size_t chunks() const { return chunks_; }
  /// Bytes of their frames.
  [[nodiscard]] std::size_t chunk_bytes() const { return chunk_bytes_; }

 private:
  [[nodiscard]] bool may_go() const;
  [[nodiscard]] Turn choose();
  [[nodiscard]] Queue& lane() { return turn_ == Turn::view ? outbox_.view_ : outbox_.requests_; }

  Outbox& outbox_;
  const WriteLimits limits_;
  Credit& credit_;
  Output& output_;
  std::size_t control_bytes_ = 0;  // in `output_`
  std::size_t updates_ = 0;        // that may still go in this write
  Turn turn_ = Turn::none;
  Pair pair_{};                 // of turn_
  Flow flow_{};                 // of turn_
  std::size_t turn_began_ = 0;  // at this size of `output_`
  std::size_t chunks_ = 0;
  std::size_t chunk_bytes_ = 0;
};

}  // namespace talus::server
