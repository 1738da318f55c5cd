// The chunks that a player wants around it.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

namespace talus::client {

/// Coarser chunks around the View, out to `radius` base chunks.
struct LodRing {
  Lod lod;                   // 1 and up; each ring is coarser and wider than the previous one
  std::uint16_t radius = 0;  // base chunks
  bool operator==(const LodRing&) const = default;
};

/// Chunks around a point: level 0 within the radii, coarser levels in the rings. The server sends the nearest
/// first, and prefers chunks ahead, along `direction`, to chunks behind.
struct View {
  VoxelPos centre;                      // base voxels
  glm::vec3 direction{0.0F};            // need not be normalised; zero: no preference
  std::uint16_t horizontal_radius = 8;  // chunks
  std::uint16_t vertical_radius = 4;    // chunks
  std::vector<LodRing> rings;
  /// Rings include every row in which the world's ground can lie, not only the rows of level 0: summits
  /// above, and land below a flying player. The first ring also covers the rows below level 0. Requires
  /// ServerLimits::view_horizon.
  bool horizon = false;
  /// Equal Views request the same chunks in the same order.
  bool operator==(const View&) const = default;
};

/// Returns rings of levels 1 to 6 from `radius` out to `farthest`, each wider than the previous one by the
/// same ratio; fewer if rounding to whole chunks would make two radii equal.
[[nodiscard]] std::vector<LodRing> rings_between(std::uint16_t radius, std::uint16_t farthest);

/// Exactly the chunks that a server sends for a View: a box of level 0, and for each ring a box of its level
/// without the columns that finer levels cover completely (talus/voxel/view_shape.h).
class ViewShape {
 public:
  ViewShape() = default;  // no chunks
  /// REQUIRES: the View has no horizon.
  explicit ViewShape(const View& view);
  /// For a world with these heights (WorldInfo::heights()).
  ViewShape(const View& view, HeightRange heights);

  [[nodiscard]] bool covers(const ChunkKey& key) const;
  /// Rows of a column at level `lod`; empty if the View does not contain the column.
  [[nodiscard]] ChunkRange rows(std::int32_t x, std::int32_t z, Lod lod) const;
  /// Calls `visit(const ChunkKey&)` for every chunk, finest level first.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    const auto narrow = [](std::int64_t at) { return static_cast<std::int32_t>(at); };
    for (const LevelBox& box : boxes_) {
      box.for_each_column([&](std::int64_t x, std::int64_t z) {
        for (std::int64_t y = box.y.first; y <= box.y.last; ++y) {
          visit(ChunkKey{{narrow(x), narrow(y), narrow(z)}, box.lod});
        }
      });
    }
  }
  /// Number of chunks of all levels.
  [[nodiscard]] std::int64_t count() const;
  /// count() if the world's edges cut off nothing: the number that Limits::view_chunks bounds.
  [[nodiscard]] std::uint64_t uncut_count() const { return uncut_count_; }

 private:
  std::vector<LevelBox> boxes_;
  std::uint64_t uncut_count_ = 0;
};

}  // namespace talus::client
