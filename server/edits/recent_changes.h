// The newest changes of chunks, voxel by voxel, for those who hold a chunk of a moment ago. Bounded: the
// oldest go.
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

/// Any thread may ask; one thread adds.
class RecentChanges {
 public:
  /// A change of more voxels is told by the whole chunk.
  static constexpr std::size_t kMostVoxels = 1'024;

  explicit RecentChanges(std::size_t capacity_bytes) : capacity_bytes_{capacity_bytes} {}

  /// What one edit changed in a chunk: `voxels` of them, and at least one.
  struct Change {
    ChunkKey key;
    std::uint64_t previous = 0;
    std::uint64_t revision = 0;
    std::uint32_t before = 0;  // where the change may be that made `previous`
    std::uint32_t voxels = 0;
  };
  /// Where the next change goes. Changes that are forgotten leave their numbers to others: it is the revision
  /// that says whether a change is the one that is meant.
  [[nodiscard]] std::uint32_t next() const { return oldest_ + static_cast<std::uint32_t>(changes_.size()); }
  /// `voxels`: those of the first change by rising index, as they are now, then those of the second, and so
  /// on.
  void add(std::span<const Change> changes, std::span<const Override> voxels);

  /// As AppliedEdits::changes_since().
  [[nodiscard]] std::optional<AppliedEdits::Changes> since(ChunkKey key, ChunkIndex::Edited now,
                                                           std::uint64_t since, std::size_t most) const;

 private:
  struct Remembered {
    Change change;
    std::uint64_t first_voxel = 0;  // its number
  };
  /// The change that made this of the chunk; null: it is not remembered.
  [[nodiscard]] const Remembered* find(ChunkKey key, ChunkIndex::Edited edited) const;
  void forget_oldest();

  std::size_t capacity_bytes_;
  mutable std::shared_mutex mutex_;
  std::deque<Remembered> changes_;  // of all chunks, by age
  std::deque<Override> voxels_;     // theirs
  std::uint32_t oldest_ = 0;        // number of the first change; the next after 2^32 - 1 is 0
  std::uint64_t oldest_voxel_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace talus::server
