// Stores which chunks Views contain, and will soon contain: chunks worth making before a client asks for
// them. Callable from any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

#include "chunks/box_cells.h"
#include "chunks/mailbox.h"

namespace talus::server {

/// Boxes of chunks by client, found by column. A cell has each box once, so a crowd in one place costs little
/// more than one client.
class WantedChunks {
 public:
  /// Replaces the client's boxes; empty: forgets the client. Throws std::bad_alloc, and then the client has
  /// no boxes.
  void set(ClientId client, std::span<const LevelBox> boxes);

  /// Returns the part of `rows` from the lowest that some client's box has of the key's column to the
  /// highest; empty if no box has one of them.
  [[nodiscard]] ChunkRange rows_of(ChunkKey column, ChunkRange rows) const;
  /// Returns true if some client's box has the key's column.
  [[nodiscard]] bool has_column(ChunkKey column) const;

  /// Returns true if no client has a box.
  [[nodiscard]] bool empty() const;

 private:
  struct Entry {
    LevelBox box;
    std::size_t clients = 0;  // number of clients that have it
  };

  /// Calls visit(LevelBox) for the boxes that have the key's column, until it returns false.
  template <typename Visit>
  void for_each_box(ChunkKey column, Visit&& visit) const;
  void add(const BoxCell& cell, const LevelBox& box);
  void remove(const BoxCell& cell, const LevelBox& box);
  /// Removes the boxes from the first `places` of the places that they have in cells.
  void remove(std::span<const LevelBox> boxes, std::size_t places);

  mutable std::mutex mutex_;
  std::unordered_map<ClientId, std::vector<LevelBox>> boxes_;
  std::unordered_map<BoxCell, std::vector<Entry>, BoxCellHash> cells_;
  std::array<std::size_t, BoxCell::kScales> entries_of_scale_{};
};

}  // namespace talus::server
