// What edits of a session cost of the rates: the one place where that is said. Chunks that nobody edited
// before cost beside voxels, however few are written or guarded there: the server has to generate each, and
// keeps those that are written in its index for ever.
#pragma once

#include <cstddef>
#include <vector>

#include <talus/edits/edit.h>
#include <talus/voxel/coords.h>

#include "chunks/chunk_source.h"
#include "limits/rates/rates.h"
#include "player/session/edit_check.h"

namespace talus::server {

class EditCosts {
 public:
  /// Chunks that are remembered as paid: those of one edit, which may be the next one's too before the first
  /// is applied.
  static constexpr std::size_t kRemembered = 2 * edits::kMaxChunks;

  /// `chunks` tells which were edited; it outlives this.
  explicit EditCosts(const ChunkSource& chunks) : chunks_{chunks} {}

  struct Priced {
    EditCost cost;
    std::vector<ChunkCoord> new_chunks;
  };
  /// `settles`: loose material around it may slide into others of its neighbours.
  [[nodiscard]] Priced price(const CheckedEdit& edit, bool settles) const;
  /// It was granted: the session pays for its new chunks once, while the newest that it paid for are
  /// remembered, whatever becomes of the edit.
  void pay(const Priced& priced);

  /// Beside itself.
  [[nodiscard]] std::size_t bytes() const { return paid_.capacity() * sizeof(ChunkCoord); }

 private:
  const ChunkSource& chunks_;
  std::vector<ChunkCoord> paid_;  // the newest last, until it is full: then a ring
  std::size_t oldest_ = 0;
};

}  // namespace talus::server
