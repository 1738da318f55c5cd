// What waits to be written to one client. Control frames go first and need no credit. While the client's
// credit lasts two pairs of flows take turns by bytes: updates of chunks that the client holds and that were
// edited since (broadcasts, and chunks that are sent again), and chunks (of requests, and of the View). So
// nothing that others do to the land keeps a client's View from coming. Chunks are shared with the cache, not
// copied. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
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

  /// What goes for an update: a frame or a small chunk, the whole chunk when it has its turn, or else
  /// nothing.
  struct Update {
    protocol::Frame frame{};
    EncodedChunkPtr chunk{};
    bool whole = false;
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
    std::erase_if(updates_, unwanted);
    std::erase_if(resends_, unwanted);
  }

  [[nodiscard]] bool sendable(const Credit& credit) const;
  [[nodiscard]] bool has_control() const { return !control_.empty(); }

  /// Appends frames to `output` until a limit is reached or nothing is sendable. Also where a lane had
  /// chunks, has none left, and it is its turn: the caller fills it again before others go on.
  ///
  /// For each chunk that leaves write(entry) is called, which may replace entry.chunk by a newer version, or
  /// returns a frame that goes in its place. For each update that leaves write_update(key) returns what goes;
  /// where that is the whole chunk, write_resend(key) returns it in its turn, or null: nothing goes. Both may
  /// push the same update again, for the next take().
  template <typename Write, typename WriteUpdate, typename WriteResend>
  Taken take(const TakeLimits& limits, Credit& credit, Output& output, Write&& write,
             WriteUpdate&& write_update, WriteResend&& write_resend) {
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
    std::size_t updates = updates_.size();  // those pushed from here on wait for the next take()
    const auto send_update = [&]() -> std::size_t {
      const ChunkKey key = updates_.front();
      updates_.pop_front();
      --updates;
      const Update update = write_update(key);
      if (update.whole) resends_.push_back(key);
      if (update.chunk != nullptr) return append(update.chunk, 0, key);
      output.append(update.frame);
      return update.frame.size();
    };
    const auto send_again = [&]() -> std::size_t {
      const ChunkKey key = resends_.front();
      resends_.pop_front();
      const EncodedChunkPtr chunk = write_resend(key);
      return chunk == nullptr ? 0 : append(chunk, 0, key);
    };
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
    wait(Pair::chunks, Flow::requests, !requests_.entries.empty());
    wait(Pair::chunks, Flow::view, !view_.entries.empty());
    while (may_go()) {
      wait(Pair::updates, Flow::broadcasts, updates > 0);
      wait(Pair::updates, Flow::resends, !resends_.empty());
      const auto turn = turns_.next();
      if (!turn) break;
      const auto [pair, flow] = *turn;
      std::size_t bytes = 0;
      if (pair == Pair::updates) {
        bytes = flow == Flow::broadcasts ? send_update() : send_again();
      } else {
        Queue& lane = flow == Flow::view ? view_ : requests_;
        if (lane.entries.empty()) break;
        bytes = send_first(lane);
      }
      turns_.charge(static_cast<double>(bytes), pair, flow);
    }
    return taken;
  }

  /// Memory of the queued control frames.
  [[nodiscard]] std::size_t control_bytes() const { return control_bytes_; }
  /// Updates that wait.
  [[nodiscard]] std::size_t updates() const { return updates_.size() + resends_.size(); }
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
  enum class Pair : std::uint8_t { updates, chunks };
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
  std::deque<ChunkKey> updates_;  // broadcasts, as far as is known
  std::deque<ChunkKey> resends_;  // those of updates that are to be the chunk again
  Queue requests_;
  Queue view_;
  std::size_t control_bytes_ = 0;
  FairQueue<Classes<Pair, 2>, Classes<Flow, 2>> turns_;
};

}  // namespace talus::server
