// Index of all edited chunks and their last revisions: in memory, looked up for every chunk that is served.
// It only grows.
#pragma once

#include <array>
#include <atomic>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <shared_mutex>
#include <vector>

#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

#include "chunks/applied_edits.h"
#include "chunks/cache/flat_map.h"
#include "chunks/edited_land.h"

namespace talus::server {

/// Any thread reads; one thread writes. A look-up in a region of 32 x 32 chunk columns without edits mostly
/// costs one load.
class ChunkIndex {
 public:
  /// Approximate memory of a region, of a column with its heap block, and of a chunk in it.
  static constexpr std::size_t kRegionBytes = 168;
  static constexpr std::size_t kColumnBytes = 120;
  static constexpr std::size_t kChunkBytes = 24;
  /// Maximum memory of one edited chunk of level 0, far from all others: at each level a chunk, a column and
  /// a region.
  static constexpr std::size_t kMaxBytesEach = (Lod::kMax + 1) * (kRegionBytes + kColumnBytes + kChunkBytes);

  struct ChunkEntry {
    std::uint64_t revision = 0;  // 0: never edited
    std::uint32_t change = 0;    // where RecentChanges may have the edit that made this revision
  };
  [[nodiscard]] ChunkEntry find(ChunkKey key) const;
  /// 0 if the chunk was never edited.
  [[nodiscard]] std::uint64_t revision(ChunkKey key) const { return find(key).revision; }
  /// See AppliedEdits::edited_rows().
  [[nodiscard]] ChunkRange rows(ChunkKey key) const;
  /// See EditedLand.
  [[nodiscard]] std::uint64_t column_revision(ChunkKey key) const;
  [[nodiscard]] std::vector<EditedColumn> edited_columns(ChunkKey key) const;

  /// See AppliedEdits. Costs one load for each region of the box without edits.
  void edited_chunks(const LevelBox& box, const ColumnFilter& wanted, std::vector<ChunkKey>& found) const;

  /// Sets the chunk's revision, unless it has a later one. Returns the revision before.
  std::uint64_t raise(ChunkKey key, ChunkEntry edited);
  /// Sets the revision of the chunk's column in the same way. Call it after raise() of all chunks of the
  /// edit.
  void raise_column(ChunkKey key, std::uint64_t revision);

  [[nodiscard]] std::size_t chunks() const { return chunks_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::size_t bytes() const { return bytes_.load(std::memory_order_relaxed); }

 private:
  struct Chunk {
    std::int32_t row = 0;
    std::uint32_t change = 0;
    std::uint64_t revision = 0;
  };
  struct Column {
    std::vector<Chunk> chunks;   // by ascending row
    std::uint64_t revision = 0;  // 0: its first edit has not raised all of its chunks yet
  };
  struct Shard {
    mutable std::shared_mutex mutex;
    FlatMap<ChunkKey, Column> columns;  // by the key of row 0
  };
  using Places = std::bitset<std::size_t{kRegionColumns} * kRegionColumns>;  // edited columns in a region
  struct Regions {
    mutable std::shared_mutex mutex;
    FlatMap<ChunkKey, Places> places;  // by the key of the region's first column, at row 0
  };
  static constexpr std::size_t kShards = 16;
  static constexpr std::size_t kRegionBits = 1U << 16U;

  [[nodiscard]] static ChunkKey column_of(ChunkKey key) { return {{key.coord.x, 0, key.coord.z}, key.lod}; }
  [[nodiscard]] static std::size_t region_bit(ChunkKey key);
  [[nodiscard]] bool is_touched(ChunkKey key) const;
  /// `region` is the region's first column.
  [[nodiscard]] Places places_of(ChunkKey region) const;

  // Regions by the hash of their position: two may share a bit, which costs one more look-up.
  std::array<std::atomic<std::uint64_t>, kRegionBits / 64> regions_{};
  std::array<Shard, kShards> shards_;
  std::array<Regions, kShards> columns_of_regions_;
  std::atomic<std::size_t> chunks_{0};
  std::atomic<std::size_t> bytes_{0};
};

}  // namespace talus::server
