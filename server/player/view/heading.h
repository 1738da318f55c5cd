// Where a View moves, and so which chunks it comes to have next.
#pragma once

#include <cstdlib>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <talus/voxel/view_shape.h>

namespace talus::server {

/// Of a View's centre, from its last few moves. Values; for one thread.
class Heading {
 public:
  /// So many chunks ahead of a View, of each level, count as wanted soon: what lies farther on in the patch
  /// that the View enters.
  static constexpr std::int64_t kAhead = 4;

  /// The View stands here now. A move of more than `radius` base chunks is a jump, after which nothing is
  /// known.
  void move_to(glm::i64vec3 centre, int radius) {
    const glm::i64vec3 moved = centre - centre_.value_or(centre);
    centre_ = centre;
    if (moved.x == 0 && moved.z == 0) return;
    const bool jump = std::abs(moved.x) > radius || std::abs(moved.z) > radius;
    moves_ = jump ? glm::dvec2{} : moves_ * kKept + glm::dvec2{moved.x, moved.z};
  }

  /// The boxes, outer and inner, with kAhead chunks more where the View comes to have them.
  [[nodiscard]] std::vector<LevelBox> ahead(std::vector<LevelBox> boxes) const {
    for (LevelBox& box : boxes) {
      extend(box.x, moves_.x, box.lod);
      extend(box.z, moves_.y, box.lod);
      // What the finer level leaves behind.
      shorten(box.inner_x, moves_.x);
      shorten(box.inner_z, moves_.y);
    }
    return boxes;
  }

 private:
  static constexpr double kKept = 0.75;   // of what earlier moves count, after each move
  static constexpr double kSteady = 0.2;  // moves that count less do not count

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
