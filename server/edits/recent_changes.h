// The newest changes of chunks, voxel by voxel, for those who hold a chunk of a moment ago. Bounded: the
// oldest go.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <shared_mutex>
#include <vector>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

#include "cache/flat_map.h"
#include "edits/applied_edits.h"

namespace talus::server {

/// Any thread may ask; one thread adds.
class RecentChanges {
 public:
  /// A change of more voxels is told by the whole chunk.
  static constexpr std::size_t kMostVoxels = 1'024;

  explicit RecentChanges(std::size_t capacity_bytes) : capacity_bytes_{capacity_bytes} {}

  /// What one edit changed in a chunk: voxels by rising index, as they are now.
  struct Change {
    ChunkKey key;
    std::uint64_t previous = 0;
    std::uint64_t revision = 0;
    std::vector<Override> voxels;  // empty: what changed is not known, and nothing before it counts any more
  };
  void add(std::vector<Change> changes);

  /// As AppliedEdits::changes_since().
  [[nodiscard]] std::optional<AppliedEdits::Changes> since(ChunkKey key, std::uint64_t since,
                                                           std::size_t most) const;

 private:
  struct Remembered {
    Change change;
    std::uint64_t before = 0;  // number of the chunk's change before it; 0: it has none that is remembered
  };
  void forget_oldest();

  std::size_t capacity_bytes_;
  mutable std::shared_mutex mutex_;
  std::deque<Remembered> changes_;           // of all chunks, by age
  std::uint64_t oldest_ = 1;                 // number of the first of them
  FlatMap<ChunkKey, std::uint64_t> newest_;  // number of a chunk's last change
  std::size_t bytes_ = 0;
};

}  // namespace talus::server
