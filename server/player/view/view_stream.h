// The state of one View's chunks: sent, in flight, or still to be sent and in which order. No I/O. Memory:
// one byte per chunk of the View, and eight for each chunk still to be sent.
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
  /// and sent again if it returns; the same holds for a chunk that left in one of the areas `between`, which
  /// were replaced before they were applied.
  ///
  /// `has_base`: the client has every chunk as generated. Of the chunks that were not sent, the edited ones
  /// are to be sent, and the others are done: call mark_edited() next.
  void replace(AreaOfInterest wanted, std::span<const AreaOfInterest> between = {}, bool has_base = false);
  [[nodiscard]] bool has_base() const { return has_base_; }
  /// Returns true if the column, which is in the area, has chunks for which mark_edited() decides.
  [[nodiscard]] bool is_undecided(ChunkKey column) const;
  /// `edited` has the edited chunks of all columns for which is_undecided() is true, and perhaps others.
  void mark_edited(std::span<const ChunkKey> edited);
  [[nodiscard]] std::vector<LevelBox> boxes() const { return interest_.boxes(); }

  /// The nearest chunk still to be sent.
  [[nodiscard]] std::optional<ChunkKey> nearest();
  /// Returns true if the chunk, which must be in the area, is in the two nearest rings.
  [[nodiscard]] bool is_near(ChunkKey key) const { return interest_.is_near(key); }
  /// Returns true if a near chunk is still to be sent.
  [[nodiscard]] bool near_to_send() const {
    bool any = false;
    interest_.for_each_near(
        [&](AreaOfInterest::Place place) { any = any || states_[place] == State::to_send; });
    return any;
  }
  /// Calls visit(column) for each column of the area in the aligned square of edge `edge` that contains
  /// `key`, starting with the column of `key`.
  template <typename Visit>
  void for_each_column_beside(ChunkKey key, int edge, Visit&& visit) const {
    visit(key);
    // The coordinates' range ends at a square's edge, as the world does.
    const std::int32_t x = key.coord.x & -edge;
    const std::int32_t z = key.coord.z & -edge;
    for (std::int32_t i = 0; i < edge * edge; ++i) {
      const ChunkKey column{{x + i % edge, key.coord.y, z + i / edge}, key.lod};
      if (column != key && interest_.place_of(column)) visit(column);
    }
  }
  /// Calls visit(chunk) for the chunks of the column, from below, that are still to be sent and at most
  /// `chunks` chunks of their size farther away than `nearest`. visit() may start() the chunk.
  template <typename Visit>
  void for_each_to_send(ChunkKey column, ChunkKey nearest, int chunks, Visit&& visit) const {
    const ChunkRange rows = interest_.rows_of(column);
    for (std::int64_t y = rows.first; y <= rows.last; ++y) {
      const ChunkKey chunk{{column.coord.x, static_cast<std::int32_t>(y), column.coord.z}, column.lod};
      if (states_[*interest_.place_of(chunk)] != State::to_send) continue;
      if (interest_.within(chunk, nearest, chunks << chunk.lod.value())) visit(chunk);
    }
  }
  /// Moves a chunk from to be sent to in flight.
  void start(ChunkKey key);
  /// Moves a chunk from in flight back to be sent.
  void put_back(ChunkKey key);
  /// The chunk in flight was sent, or never will be.
  void done(ChunkKey key);

  /// Number of chunks of the area that are not done.
  [[nodiscard]] std::size_t left() const { return left_; }
  /// Number of chunks that nearest() will return.
  [[nodiscard]] std::size_t to_send() const { return left_ - in_flight_; }

  /// Returns a chunk of each column of the area, each column once after replace(); nullopt after the last.
  [[nodiscard]] std::optional<ChunkKey> next_column() { return interest_.next_column(next_column_); }

  /// Ends the chunks of the column of `key`, from below, that are not done and for which ends(chunk,
  /// in_flight) returns true.
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

  /// Returns true if the area has the chunk and it is not done.
  [[nodiscard]] bool wants(ChunkKey key) const {
    const auto place = interest_.place_of(key);
    return place && states_[*place] != State::done;
  }
  /// Returns true if the area has the chunk and it is done.
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
  /// Approximate memory.
  [[nodiscard]] std::size_t bytes() const {
    return states_.capacity() * sizeof(State) + (far_.capacity() + near_.capacity()) * sizeof(std::uint64_t);
  }

 private:
  // Chunks to be sent are in near_ or far_; chunks in flight may still be there. Undecided: only until
  // mark_edited().
  enum class State : std::uint8_t { to_send, in_flight, in_flight_unlisted, done, undecided };
  static bool is_in_flight(State state) {
    return state == State::in_flight || state == State::in_flight_unlisted;
  }

  /// Handles a chunk taken off near_ or far_. Returns true if it is to be sent; otherwise it is no longer
  /// listed.
  [[nodiscard]] bool unlist(AreaOfInterest::Place place);
  /// Drops chunks from near_ that are no longer to be sent, and refills it when it is empty.
  void refill_near();
  /// Moves the nearest rings of far_ to near_.
  void move_near();

  /// Clears the lists of chunks to be sent.
  void clear_lists();
  /// Lists the chunk if it is to be sent, and counts it if it is in flight.
  void list(ChunkKey key, AreaOfInterest::Place place);

  AreaOfInterest interest_;
  bool has_base_ = false;
  std::vector<State> states_;  // by place
  std::size_t left_ = 0;       // in states_, not done
  AreaOfInterest::ColumnCursor next_column_;

  // The chunks to be sent, and some that no longer are. A View can be large, and is mostly replaced before it
  // is sent whole: only the nearest rings are sorted exactly; the others when their turn comes.
  std::vector<std::uint64_t> near_;  // ranks, the nearest last
  std::vector<std::uint64_t> far_;   // coarse priorities
  std::uint64_t near_end_ = 0;       // coarse priority at which far_ begins

  std::size_t in_flight_ = 0;
};

}  // namespace talus::server
