// Computes the chunks of a View. Server and client share this code, so the server sends exactly the chunks
// that the client expects. Pure functions of values; any thread may call them. Test vectors for other
// implementations: core/voxel/vectors.
//
// A View has a centre, which is a base chunk c (the chunk of level 0 that holds the wire's centre voxel,
// floor(voxel / 32) along each axis), a horizontal radius h, a vertical radius v, both in base chunks, and
// rings (l_1, r_1), (l_2, r_2), ... of a level and a radius in base chunks, both ascending. With l_0 = 0 and
// r_0 = h, level l_i of the View has, in chunks of that level and with floor division:
//
//   outer box:  X_i = (c.x - r_i) / 2^l_i  to  (c.x + r_i) / 2^l_i    both ends included; Z_i accordingly
//               Y_i = (c.y - v)   / 2^l_i  to  (c.y + v)   / 2^l_i
//   inner box:  for i > 0, the columns of level l_i entirely inside the columns of the previous level, which
//               are the base columns from  b = first(X_(i-1)) * 2^l_(i-1)  to, but excluding,
//               e = (last(X_(i-1)) + 1) * 2^l_(i-1).
//               Along x they are  ceil(b / 2^l_i)  to  floor(e / 2^l_i) - 1; along z accordingly. Either may
//               be empty.
//
// A chunk (x, y, z) of level l_i belongs to the View if x is in X_i, y in Y_i and z in Z_i, unless x and z
// are both in the inner box. The inner box is computed from the previous level after alignment to that
// level's chunks, which is wider than r_(i-1) base chunks, and it covers all rows. Finally, chunks outside
// the world, beyond chunk_limit(level), are removed.
//
// In a View with a horizon, the rings cover every row in which the world can hold anything but one rock or
// air, wherever the player is. With the world's heights (HeightRange, sent in Welcome), for i > 0:
//
//   Y_i = ((low >> l_i) - 1) / 32  to  ((high - 1) >> l_i) / 32      instead of the above
//   the inner box of the first ring is empty, as level 0 does not contain all rows of its columns.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/voxel/coords.h>

namespace talus {

/// Chunk coordinates along one axis, both ends included; empty if last < first.
struct ChunkRange {
  std::int64_t first = 0;
  std::int64_t last = -1;

  [[nodiscard]] std::uint64_t size() const {
    return last < first ? 0 : static_cast<std::uint64_t>(last - first) + 1;
  }
  [[nodiscard]] bool contains(std::int64_t at) const { return first <= at && at <= last; }
  bool operator==(const ChunkRange&) const = default;
};

[[nodiscard]] inline ChunkRange overlap(ChunkRange a, ChunkRange b) {
  return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

/// Chunks of a coarser level around a View.
struct ViewRing {
  Lod lod;         // 1 and up
  int radius = 0;  // base chunks
  bool operator==(const ViewRing&) const = default;
};

/// Input of level_boxes().
struct ViewExtent {
  glm::i64vec3 centre{};  // base chunk; each component within +-2^59, possibly outside the world
  int horizontal_radius = 0;
  int vertical_radius = 0;
  std::vector<ViewRing> rings;  // ascending levels and radii; radii below 2^24, or below 2^16 with a horizon
  /// The world's heights if the View has a horizon. Heights outside the world are clamped to its edge.
  std::optional<HeightRange> horizon = std::nullopt;
};

/// The chunks of one level of a View: the outer box without the columns of the inner one.
struct LevelBox {
  Lod lod;
  ChunkRange x, y, z;
  ChunkRange inner_x, inner_z;

  /// True if the View contains the column at this level; it then contains all rows `y` of it.
  [[nodiscard]] bool has_column(std::int64_t at_x, std::int64_t at_z) const {
    return x.contains(at_x) && z.contains(at_z) && !(inner_x.contains(at_x) && inner_z.contains(at_z));
  }
  [[nodiscard]] bool contains(ChunkCoord chunk) const {
    return y.contains(chunk.y) && has_column(chunk.x, chunk.z);
  }
  [[nodiscard]] std::uint64_t count() const;
  bool operator==(const LevelBox&) const = default;

  /// Calls visit(x, z) for every column, z slowest.
  template <typename Visit>
  void for_each_column(Visit&& visit) const {
    for (std::int64_t at_z = z.first; at_z <= z.last; ++at_z) {
      for (std::int64_t at_x = x.first; at_x <= x.last; ++at_x) {
        if (has_column(at_x, at_z)) visit(at_x, at_z);
      }
    }
  }
};

/// Selects whether the world's edge cuts a View. Limits on the size of a View apply to the uncut View.
enum class WorldEdge : std::uint8_t { cuts, ignored };

/// Returns level 0, then each ring, in time independent of the radii. With WorldEdge::cuts, ranges lie inside
/// the world and may be empty.
[[nodiscard]] std::vector<LevelBox> level_boxes(const ViewExtent& view, WorldEdge edge = WorldEdge::cuts);

/// Number of chunks of all levels together.
[[nodiscard]] std::uint64_t count_chunks(std::span<const LevelBox> boxes);

}  // namespace talus
