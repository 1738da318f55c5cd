// Tracks the missing chunks of a View's rings, and whether arriving chunks were expected. No I/O, no clock.
#pragma once

#include <cstddef>
#include <unordered_set>

#include <talus/client/view.h>
#include <talus/voxel/coords.h>

#include "pending_chunks.h"

namespace talus::load {

/// Remembers every chunk that left: rings leave few behind, however long a player flies.
class PendingRings {
 public:
  using Verdict = PendingChunks::Verdict;

  /// A View of this shape was sent.
  void move_to(const client::ViewShape& shape);
  /// `chunk` is of level 1 or above.
  [[nodiscard]] Verdict arrive(ChunkKey chunk);
  [[nodiscard]] bool covers(ChunkKey chunk) const { return shape_.covers(chunk); }
  [[nodiscard]] ChunkRange rows(std::int32_t x, std::int32_t z, Lod lod) const {
    return shape_.rows(x, z, lod);
  }

  /// All chunks of the rings that are not held were made by the player. Returns how many.
  std::size_t make_all();

  /// Chunks that must arrive; excludes returned ones, which the server may know to be held.
  [[nodiscard]] std::size_t waiting() const { return waiting_; }

 private:
  client::ViewShape shape_;
  std::unordered_set<ChunkKey> held_;
  std::unordered_set<ChunkKey> left_;
  std::size_t waiting_ = 0;
};

}  // namespace talus::load
