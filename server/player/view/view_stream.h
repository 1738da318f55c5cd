// Which chunks of one View were sent, are in flight, or are still to be sent, and in which order. No I/O.
// Memory: one byte a chunk of the View, and eight for each that is still to be sent.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <talus/voxel/coords.h>

#include "player/view/area_of_interest.h"

namespace talus::server {

class ViewStream {
 public:
  /// Replaces the area of interest. A chunk in both areas keeps its state. A chunk that left is forgotten,
  /// and sent again when it comes back; so is one that left in one of the areas `between`, which were
  /// replaced before they were looked at.
  void replace(AreaOfInterest wanted, std::span<const AreaOfInterest> between = {});

  /// The nearest chunk that is still to be sent.
  [[nodiscard]] std::optional<ChunkKey> nearest();
  /// Of a chunk of the area: whether it is of the two nearest rings.
  [[nodiscard]] bool is_near(ChunkKey key) const { return interest_.is_near(key); }
  /// Whether one of those is still to be sent.
  [[nodiscard]] bool near_to_send() const {
    bool any = false;
    interest_.for_each_near(
        [&](AreaOfInterest::Place place) { any = any || states_[place] == State::to_send; });
    return any;
  }
  /// Calls visit(column) for each column of the area in the square of `edge` columns a side, aligned to its
  /// size, in which `key` lies; that of `key` first.
  template <typename Visit>
  void for_each_column_beside(ChunkKey key, int edge, Visit&& visit) const {
    visit(key);
    // The square ends with the numbers, where the world does.
    const std::int32_t x = key.coord.x & -edge;
    const std::int32_t z = key.coord.z & -edge;
    for (std::int32_t i = 0; i < edge * edge; ++i) {
      const ChunkKey column{{x + i % edge, key.coord.y, z + i / edge}, key.lod};
      if (column != key && interest_.place_of(column)) visit(column);
    }
  }
  /// Calls visit(chunk) for the chunks of the key's column, from below, that are still to be sent and at most
  /// so many chunks of their size farther away than `nearest`. visit() may start() the chunk.
  template <typename Visit>
  void for_each_to_send(ChunkKey column, ChunkKey nearest, int chunks, Visit&& visit) const {
    const ChunkRange rows = interest_.rows_of(column);
    for (std::int64_t y = rows.first; y <= rows.last; ++y) {
      const ChunkKey chunk{{column.coord.x, static_cast<std::int32_t>(y), column.coord.z}, column.lod};
      if (states_[*interest_.place_of(chunk)] != State::to_send) continue;
      if (interest_.within(chunk, nearest, chunks << chunk.lod.value())) visit(chunk);
    }
  }
  /// A chunk that is to be sent is in flight from here on.
  void start(ChunkKey key);
  /// A chunk in flight is still to be sent after all.
  void put_back(ChunkKey key);
  /// A chunk in flight was sent, or never will be.
  void done(ChunkKey key);

  /// Chunks of the area that are not done.
  [[nodiscard]] std::size_t left() const { return left_; }
  /// Those of them that nearest() will give.
  [[nodiscard]] std::size_t to_send() const { return left_ - in_flight_; }

  /// A chunk of each column of the area, each column once after replace(); none after the last.
  [[nodiscard]] std::optional<ChunkKey> next_column() { return interest_.next_column(next_column_); }

  /// Ends every chunk of `key`'s column, from below, that is not done and for which ends(chunk, in_flight)
  /// returns true.
  template <typename Ends>
  void done_in_column(ChunkKey key, Ends&& ends) {
    const ChunkRange rows = interest_.rows_of(key);
    for (std::int64_t y = rows.first; y <= rows.last; ++y) {
      const ChunkKey chunk{{key.coord.x, static_cast<std::int32_t>(y), key.coord.z}, key.lod};
      State& state = states_[*interest_.place_of(chunk)];
      if (state == State::done || !ends(chunk, is_in_flight(state))) continue;
      if (is_in_flight(state)) --in_flight_;
      state = State::done;
      --left_;
    }
  }

  /// Whether the area has the chunk, and it is not done.
  [[nodiscard]] bool wants(ChunkKey key) const {
    const auto place = interest_.place_of(key);
    return place && states_[*place] != State::done;
  }
  /// Whether the area has the chunk, and it is done.
  [[nodiscard]] bool is_done(ChunkKey key) const {
    const auto place = interest_.place_of(key);
    return place && states_[*place] == State::done;
  }
  /// Calls visit(ChunkKey) for every chunk of the area that is done.
  template <typename Visit>
  void for_each_done(Visit&& visit) const {
    interest_.for_each([&](ChunkKey key, AreaOfInterest::Place place) {
      if (states_[place] == State::done) visit(key);
    });
  }
  [[nodiscard]] bool in_flight(ChunkKey key) const {
    const auto place = interest_.place_of(key);
    return place && is_in_flight(states_[*place]);
  }
  [[nodiscard]] std::size_t in_flight_count() const { return in_flight_; }
  /// Memory held, roughly.
  [[nodiscard]] std::size_t bytes() const {
    return states_.capacity() * sizeof(State) + (far_.capacity() + near_.capacity()) * sizeof(std::uint64_t);
  }

 private:
  // What is to be sent is in near_ or far_; what is in flight may still be there, or not.
  enum class State : std::uint8_t { to_send, in_flight, in_flight_unlisted, done };
  static bool is_in_flight(State state) {
    return state == State::in_flight || state == State::in_flight_unlisted;
  }

  /// Whether a chunk that is taken off near_ or far_ is to be sent; where not, it is listed no more.
  [[nodiscard]] bool unlist(AreaOfInterest::Place place);
  /// Drops from near_ what is not to be sent any more, and refills it when it is empty.
  void refill_near();
  /// Moves the nearest rings of far_ to near_.
  void move_near();

  AreaOfInterest interest_;
  std::vector<State> states_;  // by place
  std::size_t left_ = 0;       // of them, not done
  AreaOfInterest::ColumnCursor next_column_;

  // The chunks to be sent, and some that no longer are. A View can be large, and is mostly replaced before
  // it is sent whole: only the nearest rings are sorted exactly, the others when their turn comes.
  std::vector<std::uint64_t> near_;  // ranks, the nearest last
  std::vector<std::uint64_t> far_;   // coarse priorities
  std::uint64_t near_end_ = 0;       // the coarse priority at which far_ begins

  std::size_t in_flight_ = 0;
};

}  // namespace talus::server
