// Tracks which chunks of the current View were delivered, and which of the departed ones can be reused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <talus/client/chunk_store.h>
#include <talus/client/received_chunk.h>
#include <talus/client/view.h>
#include <talus/voxel/coords.h>

namespace talus::client {

class ViewTracker {
 public:
  /// Keeps about `keep_bytes` of chunks that left the View.
  explicit ViewTracker(std::size_t keep_bytes) : keep_bytes_{keep_bytes}, kept_{keep_bytes} {}

  /// Replaces the View, in a world of these heights; returns the delivered chunks that it no longer covers.
  [[nodiscard]] std::vector<ChunkKey> replace(const View& view, HeightRange heights = {});

  [[nodiscard]] const std::optional<View>& view() const { return view_; }
  [[nodiscard]] const ViewShape& shape() const { return shape_; }

  /// Records a delivered chunk. Returns false, without effect, if a higher revision was delivered before.
  [[nodiscard]] bool deliver(const ReceivedChunk& chunk);
  /// The server has another store, whose revisions are not comparable with earlier ones.
  void forget_revisions();
  /// As well, where the server sends only edits: edited chunks are out of date until they are delivered
  /// again.
  void outdate_edited();

  /// Chunks of the View that were not delivered, or are out of date.
  [[nodiscard]] std::vector<ChunkKey> missing() const;
  /// True if no chunk is missing.
  [[nodiscard]] bool complete() const {
    return static_cast<std::int64_t>(delivered_.size()) == shape_.count() && outdated_.empty();
  }

  [[nodiscard]] bool was_delivered(const ChunkKey& key) const { return delivered_.contains(key); }
  /// True if the chunk was delivered and is not out of date.
  [[nodiscard]] bool has_current(const ChunkKey& key) const {
    return was_delivered(key) && !outdated_.contains(key);
  }
  /// The hash of a current chunk that was delivered as generated.
  [[nodiscard]] std::optional<ContentHash> generated_hash(const ChunkKey& key) const;

  /// A chunk that left the View was edited since: it is held no longer.
  void forget_left(const ChunkKey& key) { kept_.erase(key); }

  /// The chunk if it is current and still in memory: kept after it left, or delivered and still held by the
  /// caller.
  [[nodiscard]] std::optional<ReceivedChunk> held(const ChunkKey& key) const;
  /// At most `max` held chunks of the View, without uniform ones. After a reconnect the server has sent
  /// nothing yet, so delivered chunks count too.
  [[nodiscard]] std::vector<ReceivedChunk> known(std::size_t max, bool with_delivered) const;

 private:
  /// Does not own the chunk: it is gone when the caller and `kept_` release it.
  struct DeliveredChunk {
    std::uint64_t revision = 0;
    ContentHash hash;
    std::weak_ptr<const Chunk> chunk;
  };
  [[nodiscard]] static std::optional<ReceivedChunk> still_there(const ChunkKey& key,
                                                                const DeliveredChunk& chunk);

  std::optional<View> view_;
  ViewShape shape_;
  std::unordered_map<ChunkKey, DeliveredChunk> delivered_;
  std::unordered_set<ChunkKey> outdated_;  // of delivered_
  std::size_t keep_bytes_;
  ChunkStore kept_;
};

}  // namespace talus::client
