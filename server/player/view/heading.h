// Predicts a View's movement, and thus the chunks that it will need next.
#pragma once

#include <cstdlib>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <talus/voxel/view_shape.h>

namespace talus::server {

/// The recent direction of a View's centre, from its last few moves. A value type; for one thread.
class Heading {
 public:
  /// Chunks of each level within this distance ahead of a View count as wanted soon: the chunks farther on in
  /// the patch that the View enters.
  static constexpr std::int64_t kAhead = 4;

  /// Sets the View's current centre. A move of more than `radius` base chunks is a jump, which resets the
  /// direction.
  void move_to(glm::i64vec3 centre, int radius) {
    const glm::i64vec3 moved = centre - centre_.value_or(centre);
    centre_ = centre;
    if (moved.x == 0 && moved.z == 0) return;
    const bool jump = std::abs(moved.x) > radius || std::abs(moved.z) > radius;
    moves_ = jump ? glm::dvec2{} : moves_ * kKept + glm::dvec2{moved.x, moved.z};
  }

  /// Extends the boxes, outer and inner, by kAhead chunks in the direction of movement.
  [[nodiscard]] std::vector<LevelBox> ahead(std::vector<LevelBox> boxes) const {
    for (LevelBox& box : boxes) {
      extend(box.x, moves_.x, box.lod);
      extend(box.z, moves_.y, box.lod);
      // The columns that the finer level leaves behind.
      shorten(box.inner_x, moves_.x);
      shorten(box.inner_z, moves_.y);
    }
    return boxes;
  }

 private:
  static constexpr double kKept = 0.75;   // weight of earlier moves after each new one
  static constexpr double kSteady = 0.2;  // smaller moves are ignored

  static void extend(ChunkRange& range, double move, Lod lod) {
    const ChunkRange world{-chunk_limit(lod), chunk_limit(lod) - 1};
    if (range.size() == 0) return;
    if (move > kSteady) range.last = std::min(range.last + kAhead, world.last);
    if (move < -kSteady) range.first = std::max(range.first - kAhead, world.first);
  }

  static void shorten(ChunkRange& range, double move) {
    if (move > kSteady) range.first += kAhead;
    if (move < -kSteady) range.last -= kAhead;
  }

  std::optional<glm::i64vec3> centre_;
  glm::dvec2 moves_{};
};

}  // namespace talus::server
