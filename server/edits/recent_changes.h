// The newest changes of chunks, voxel by voxel, for clients that hold a recent version of a chunk. Bounded:
// the oldest are dropped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <shared_mutex>
#include <span>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

#include "chunks/applied_edits.h"
#include "edits/chunk_index.h"

namespace talus::server {

/// Any thread reads; one thread adds.
class RecentChanges {
 public:
  /// Maximum voxels of a remembered change; after a larger one clients receive the whole chunk.
  static constexpr std::size_t kMaxVoxels = 1'024;

  explicit RecentChanges(std::size_t capacity_bytes) : capacity_bytes_{capacity_bytes} {}

  /// The voxels that one edit changed in a chunk: `voxels`, at least one.
  struct Change {
    ChunkKey key;
    std::uint64_t previous = 0;
    std::uint64_t revision = 0;
    std::uint32_t before = 0;  // number of the change that made `previous`, if remembered
    std::uint32_t voxels = 0;
  };
  /// Number of the next change. Numbers of dropped changes are reused: the revision identifies a change.
  [[nodiscard]] std::uint32_t next() const { return oldest_ + static_cast<std::uint32_t>(changes_.size()); }
  /// `voxels`: the current voxels of the first change by ascending index, then of the second, and so on.
  void add(std::span<const Change> changes, std::span<const Override> voxels);

  /// See AppliedEdits::changes_since().
  [[nodiscard]] std::optional<AppliedEdits::Changes> since(ChunkKey key, ChunkIndex::ChunkEntry now,
                                                           std::uint64_t since, std::size_t max_voxels) const;

 private:
  struct StoredChange {
    Change change;
    std::uint64_t first_voxel = 0;  // its number
  };
  /// The change that made this revision of the chunk; null if it is not remembered.
  [[nodiscard]] const StoredChange* find(ChunkKey key, ChunkIndex::ChunkEntry edited) const;
  void forget_oldest();

  std::size_t capacity_bytes_;
  mutable std::shared_mutex mutex_;
  std::deque<StoredChange> changes_;  // all chunks, oldest first
  std::deque<Override> voxels_;       // in the order of changes_
  std::uint32_t oldest_ = 0;          // number of the first change; the next after 2^32 - 1 is 0
  std::uint64_t oldest_voxel_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace talus::server
