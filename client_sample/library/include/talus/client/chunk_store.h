// The chunks that a client holds. Gives a mesher one chunk with a rim of its neighbours' voxels.
//
//   ChunkStore store{256 << 20};
//   events.on_chunk = [&](const ReceivedChunk& chunk) { store.put(chunk); remesh_around(chunk.key); };
//   events.on_left_view = [&](ChunkKey key) { store.erase(key); };
//   ...
//   std::vector<MaterialId> voxels(apron_volume(1));
//   const ApronGaps gaps = store.apron(key, 1, kAir, voxels);
//   if (gaps.none()) mesh(voxels);
//
// Not thread-safe, but the chunks are immutable: a mesher's thread may keep the result of find().
#pragma once

#include <bitset>
#include <cstddef>
#include <list>
#include <memory>
#include <span>
#include <unordered_map>

#include <talus/client/received_chunk.h>

namespace talus::client {

inline constexpr int kMaxApron = 2;  // voxels

/// Voxels of a chunk extended by `width` on every side.
[[nodiscard]] constexpr std::size_t apron_volume(int width) {
  const auto edge = static_cast<std::size_t>(kChunkSize + 2 * width);
  return edge * edge * edge;
}

/// The chunks missing among the 3 x 3 x 3 around a key. Bit neighbour_index(dx, dy, dz).
using ApronGaps = std::bitset<27>;

/// Each of dx, dy, dz is -1, 0 or 1; (0, 0, 0) is the chunk itself.
[[nodiscard]] constexpr std::size_t neighbour_index(int dx, int dy, int dz) {
  return static_cast<std::size_t>(((dy + 1) * 3 + dz + 1) * 3 + dx + 1);
}

class ChunkStore {
 public:
  /// Holds about `max_bytes` of decoded voxels and evicts the least recently used chunks above that, but
  /// never the chunk put last.
  explicit ChunkStore(std::size_t max_bytes) : max_bytes_{max_bytes} {}

  /// Replaces the chunk of its key unless the held one has a higher revision. An unchanged() chunk only
  /// counts as a use. Revisions of different stores (WorldInfo::store_id) are not comparable: call clear() in
  /// between.
  void put(const ReceivedChunk& chunk);
  void erase(const ChunkKey& key);
  void clear();

  /// Null if the chunk is not held. Counts as a use.
  [[nodiscard]] std::shared_ptr<const Chunk> find(const ChunkKey& key);

  /// The chunk as received; null if not held. Valid until the next change. Does not count as a use.
  [[nodiscard]] const ReceivedChunk* look(const ChunkKey& key) const;

  /// Does not count as a use.
  [[nodiscard]] bool contains(const ChunkKey& key) const { return held_.contains(key); }

  [[nodiscard]] std::size_t size() const { return held_.size(); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

  /// Writes (32 + 2 width)^3 voxels, starting `width` below the chunk's lowest corner, y slowest, then z,
  /// then x. `width` is 0 to kMaxApron; `out` has exactly apron_volume(width) elements. Neighbours are of the
  /// same level. Voxels of chunks that are not held become `filler`, and the result reports these chunks
  /// (with width 0, only the chunk itself). `max_bytes` must allow 27 chunks, or neighbours evict each other.
  [[nodiscard]] ApronGaps apron(const ChunkKey& key, int width, MaterialId filler, std::span<MaterialId> out);

  /// Calls `visit(const ReceivedChunk&)` for every chunk held, in unspecified order.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for (const auto& chunk : by_use_) visit(chunk);
  }

 private:
  using ByUse = std::list<ReceivedChunk>;  // most recently used first
  std::size_t max_bytes_;
  std::size_t bytes_ = 0;
  ByUse by_use_;
  std::unordered_map<ChunkKey, ByUse::iterator> held_;
};

}  // namespace talus::client
