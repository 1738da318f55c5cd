// What of a session's current View was sent, is under way, and is still to come. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <unordered_set>
#include <vector>

#include <talus/voxel/coords.h>

#include "stream/interest.h"

namespace talus::server {

class ViewStream {
 public:
  /// Replaces what is wanted. What stays wanted keeps its state; the result is what was under way and is
  /// wanted no more. A chunk that left is forgotten, so that it is sent again when it comes back.
  [[nodiscard]] std::vector<ChunkKey> replace(Interest wanted);

  /// The most wanted chunk that is neither under way nor sent, now under way.
  [[nodiscard]] std::optional<ChunkKey> next();
  /// A chunk under way could not be had: it is wanted again.
  void put_back(ChunkKey key);
  /// A chunk under way was sent, or will never be.
  void done(ChunkKey key);

  [[nodiscard]] bool under_way(ChunkKey key) const { return under_way_.contains(key); }
  [[nodiscard]] std::size_t under_way_count() const { return under_way_.size(); }

 private:
  enum class State : std::uint8_t { wanted, under_way, done };

  void leave(ChunkKey key, State state);
  /// Moves the nearest rings of far_ to near_.
  void approach();

  using Ranks = std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<>>;

  Interest interest_;
  std::vector<State> states_;  // by place

  // The chunks in state wanted. A View may have many, and is mostly replaced before its end is reached: so
  // only the nearest rings are put in order, and the others when their turn comes.
  Ranks near_;
  std::vector<std::uint64_t> far_;  // rough ranks
  std::uint64_t near_end_ = 0;      // the rough rank at which far_ begins

  std::unordered_set<ChunkKey> under_way_;  // few
};

}  // namespace talus::server
