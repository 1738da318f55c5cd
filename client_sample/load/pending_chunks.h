// Tracks the missing chunks of a player's View, and whether arriving chunks were expected. No I/O, no clock.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/voxel/view_shape.h>

namespace talus::load {

using Clock = std::chrono::steady_clock;
using Time = Clock::time_point;

/// Chunks of level 0, both corners included; empty if high < low.
struct Box {
  glm::i64vec3 low{0};
  glm::i64vec3 high{-1};
  bool operator==(const Box&) const = default;

  [[nodiscard]] bool contains(const glm::i64vec3& at) const {
    return low.x <= at.x && at.x <= high.x && low.y <= at.y && at.y <= high.y && low.z <= at.z &&
           at.z <= high.z;
  }
  [[nodiscard]] bool meets(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y &&
           low.z <= other.high.z && other.low.z <= high.z;
  }
  [[nodiscard]] glm::i64vec3 size() const { return high - low + std::int64_t{1}; }
};

/// The chunks of a View around a chunk, inside the world.
[[nodiscard]] Box box_around(const glm::i64vec3& centre, int horizontal_radius, int vertical_radius);

class PendingChunks {
 public:
  enum class Verdict : std::uint8_t {
    came,       // awaited
    repeated,   // already held, but it left the View and returned, so messages may have crossed
    duplicate,  // already held
    stale,      // in an earlier View
    outside,    // in no View
  };
  struct Arrival {
    Verdict verdict{};
    Time since{};       // for `came`: due time of the View that first wanted it
    bool join = false;  // for `came`: that View shared nothing with the previous one
    std::uint32_t steps_late = 0;
    /// For arrivals in the first View after a join or a jump, before any step: distance in rings to the
    /// nearest ring still awaited. -1 if order is not checked.
    std::int64_t ring_gap = -1;
  };
  struct MissedChunk {
    Time since{};
    bool join = false;
    bool returned = false;
  };

  /// Sends a View due at `due` at `now`, which is later if this program was late: chunks for the previous
  /// View may be in flight until then. Chunks shared with the previous View keep their state; returns the
  /// chunks that were awaited and are no longer wanted.
  [[nodiscard]] std::vector<MissedChunk> move_to(const Box& box, const glm::i64vec3& centre, Time due,
                                                 Time now);
  [[nodiscard]] Arrival arrive(ChunkCoord chunk);
  /// All chunks still awaited were made by the player. Returns how many.
  std::size_t make_all();
  /// Returns and forgets the chunks still awaited.
  [[nodiscard]] std::vector<MissedChunk> give_up();

  [[nodiscard]] const Box& box() const { return box_; }
  /// Chunks that must arrive; excludes returned ones, which the server may know to be held.
  [[nodiscard]] std::size_t waiting() const { return waiting_; }
  /// Awaited chunks in the two nearest rings: the 27 chunks around the player.
  [[nodiscard]] std::size_t near_waiting() const { return near_waiting_; }
  /// Due time of the last join or jump.
  [[nodiscard]] Time jumped() const { return jumped_; }

 private:
  // State of a chunk: 0 if held, otherwise the number of the step that first wanted it, from 1. kReturned is
  // set if it left the View and returned soon.
  using Cell = std::uint32_t;
  static constexpr Cell kReturned = Cell{1} << 31;

  struct Step {
    Time due{};
    bool join = false;
  };
  struct Past {
    Box box;
    Time until{};
  };

  [[nodiscard]] std::size_t index_of(const Box& box, const glm::i64vec3& at) const;
  [[nodiscard]] bool left_lately(const glm::i64vec3& at) const;
  [[nodiscard]] std::size_t ring_of(const glm::i64vec3& at) const;
  [[nodiscard]] MissedChunk missed(Cell cell) const;

  Box box_;
  glm::i64vec3 centre_{};
  std::vector<Cell> cells_;
  std::vector<Step> steps_;
  std::deque<Past> past_;  // newest first
  std::size_t waiting_ = 0, near_waiting_ = 0;
  Time jumped_{};
  std::vector<std::uint32_t> waiting_by_ring_;  // empty: order is not checked
};

}  // namespace talus::load
