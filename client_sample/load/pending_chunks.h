// Which chunks of a player's View have not come yet, and whether a chunk that comes was expected. No I/O, no
// clock.
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

/// Chunks of level 0, both corners included; empty where high < low.
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
    came,       // waited for
    repeated,   // held already, but it had left the View and come back, so both may cross
    duplicate,  // held already
    stale,      // of a View that has moved on
    outside,    // of no View
  };
  struct Arrival {
    Verdict verdict{};
    Time since{};       // came: when the View that first wanted it was due
    bool join = false;  // came: that View shared nothing with the one before
    std::uint32_t steps_late = 0;
    /// Came in the first View after a join or a jump, and no step since: how many rings of whole chunks
    /// nearer the nearest one is that still waits. -1 where the order is not looked at.
    std::int64_t ring_gap = -1;
  };
  struct Missed {
    Time since{};
    bool join = false;
    bool returned = false;
  };

  /// A View due at `due` is sent at `now`, later where this program was late: what the server sent for the
  /// View before is still on its way then. Its chunks that the one before had keep their state; the result is
  /// what was waited for and is wanted no more.
  [[nodiscard]] std::vector<Missed> move_to(const Box& box, const glm::i64vec3& centre, Time due, Time now);
  [[nodiscard]] Arrival arrive(ChunkCoord chunk);
  /// What still waits, which is then forgotten.
  [[nodiscard]] std::vector<Missed> give_up();

  [[nodiscard]] const Box& box() const { return box_; }
  /// Chunks that must come: not those that came back, which the server may know to be held.
  [[nodiscard]] std::size_t waiting() const { return waiting_; }
  /// Those of them in the two nearest rings: the 27 chunks around the player.
  [[nodiscard]] std::size_t near_waiting() const { return near_waiting_; }
  /// When the last join or jump was due.
  [[nodiscard]] Time jumped() const { return jumped_; }

 private:
  // A chunk's state: 0 is held; else the number of the step that first wanted it, from 1 on. With kReturned
  // it left the View and came back at once.
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
  [[nodiscard]] Missed missed(Cell cell) const;

  Box box_;
  glm::i64vec3 centre_{};
  std::vector<Cell> cells_;
  std::vector<Step> steps_;
  std::deque<Past> past_;  // the newest first
  std::size_t waiting_ = 0, near_waiting_ = 0;
  Time jumped_{};
  std::vector<std::uint32_t> waiting_by_ring_;  // empty: the order is not looked at
};

}  // namespace talus::load
