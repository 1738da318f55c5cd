// What of a session's current View was sent, is under way, and is still to come. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <span>
#include <unordered_set>
#include <vector>

#include <talus/voxel/coords.h>

#include "stream/area_of_interest.h"

namespace talus::server {

class ViewStream {
 public:
  /// Replaces what is wanted. What stays wanted keeps its state; the result is what was under way and is
  /// not any more. A chunk that left is forgotten, so that it is sent again when it comes back: also one
  /// that left in one of the Views `between`, which nobody had looked at.
  [[nodiscard]] std::vector<ChunkKey> replace(AreaOfInterest wanted,
                                              std::span<const AreaOfInterest> between = {});

  /// The most wanted chunk that is neither under way nor sent, now under way.
  [[nodiscard]] std::optional<ChunkKey> next();
  /// A chunk under way could not be had: it is wanted again.
  void put_back(ChunkKey key);
  /// A chunk under way was sent, or will never be.
  void done(ChunkKey key);

  /// Ends the chunks of `key`'s column that are wanted or under way and for which ends(chunk, under way)
  /// holds, from below.
  template <typename Ends>
  void done_in_column(ChunkKey key, Ends&& ends) {
    const ChunkRange rows = interest_.rows_of(key);
    for (std::int64_t y = rows.first; y <= rows.last; ++y) {
      const ChunkKey chunk{{key.coord.x, static_cast<std::int32_t>(y), key.coord.z}, key.lod};
      State& state = states_[*interest_.place_of(chunk)];
      if (state == State::done || !ends(chunk, state == State::under_way)) continue;
      if (state == State::under_way) under_way_.erase(chunk);
      state = State::done;
    }
  }

  /// Whether the View has the chunk, and it was neither sent nor otherwise ended.
  [[nodiscard]] bool wants(ChunkKey key) const {
    const auto place = interest_.place_of(key);
    return place && states_[*place] != State::done;
  }
  [[nodiscard]] bool under_way(ChunkKey key) const { return under_way_.contains(key); }
  /// What it holds in memory, about.
  [[nodiscard]] std::size_t bytes() const {
    return states_.capacity() * sizeof(State) + (far_.capacity() + near_.size()) * sizeof(std::uint64_t) +
           under_way_.size() * 64;
  }
  [[nodiscard]] std::size_t under_way_count() const { return under_way_.size(); }

 private:
  enum class State : std::uint8_t { wanted, under_way, done };

  void leave(ChunkKey key, State state);
  /// Leaves out of near_ what was ended otherwise, and brings more when it is empty.
  void settle_near();
  /// Moves the nearest rings of far_ to near_.
  void approach();

  using Ranks = std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<>>;

  AreaOfInterest interest_;
  std::vector<State> states_;  // by place

  // The chunks in state wanted, and some that have left it. A View may have many, and is mostly replaced
  // before its end is reached: so only the nearest rings are put in order, and the others when their turn
  // comes.
  Ranks near_;
  std::vector<std::uint64_t> far_;  // coarse priorities
  std::uint64_t near_end_ = 0;      // the coarse priority at which far_ begins

  std::unordered_set<ChunkKey> under_way_;  // few
};

}  // namespace talus::server
