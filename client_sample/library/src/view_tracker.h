// Which chunks of the current View have been delivered, and which of those that left may be used again.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <unordered_map>
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

  /// Puts `view`, in a world of these heights, in place of the one before; returns the delivered chunks that
  /// it no longer covers.
  [[nodiscard]] std::vector<ChunkKey> replace(const View& view, HeightRange heights = {});

  [[nodiscard]] const std::optional<View>& view() const { return view_; }
  [[nodiscard]] const ViewShape& shape() const { return shape_; }

  /// Notes that the chunk reached the caller. False where one of a higher revision has: then nothing changes.
  [[nodiscard]] bool deliver(const ReceivedChunk& chunk);
  /// The server has another store: its revisions say nothing about those that came before.
  void forget_revisions();

  /// Chunks of the View that were not delivered.
  [[nodiscard]] std::vector<ChunkKey> missing() const;

  [[nodiscard]] bool was_delivered(const ChunkKey& key) const { return delivered_.contains(key); }

  /// The chunk where it is still held: kept after it left, or delivered and held by the caller.
  [[nodiscard]] std::optional<ReceivedChunk> held(const ChunkKey& key) const;
  /// Chunks of the View that are held, `max` of them at most, none of them uniform. After a new connection
  /// the server has sent nothing yet, so those delivered count too.
  [[nodiscard]] std::vector<ReceivedChunk> known(std::size_t max, bool with_delivered) const;

 private:
  /// Does not keep the chunk: what nobody else holds any more is gone.
  struct Delivered {
    std::uint64_t revision = 0;
    ContentHash hash;
    std::weak_ptr<const Chunk> chunk;
  };
  [[nodiscard]] static std::optional<ReceivedChunk> still_there(const ChunkKey& key, const Delivered& chunk);

  std::optional<View> view_;
  ViewShape shape_;
  std::unordered_map<ChunkKey, Delivered> delivered_;
  std::size_t keep_bytes_;
  ChunkStore kept_;
};

}  // namespace talus::client
