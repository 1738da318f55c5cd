// What a player wants to have around it.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

namespace talus::client {

/// Its name in 0.1; goes with 0.3.
using Span [[deprecated("its name is talus::ChunkRange")]] = ChunkRange;

/// Coarser chunks around the view, out to `radius` base chunks.
struct LodRing {
  Lod lod;                   // 1 and up; each ring is coarser and farther out than the one before
  std::uint16_t radius = 0;  // base chunks
  bool operator==(const LodRing&) const = default;
};

/// Chunks around a point: of level 0 within the radii, of coarser levels in the rings. The server sends
/// the nearest first, and what lies along `direction` before what lies behind.
struct View {
  VoxelPos centre;                      // base voxels
  glm::vec3 direction{0.0F};            // of any length; zero: no preference
  std::uint16_t horizontal_radius = 8;  // chunks
  std::uint16_t vertical_radius = 4;    // chunks
  std::vector<LodRing> rings;
  /// The rings have all rows that the world's ground can lie in, not only those as high as level 0: summits
  /// above it, and land beneath who flies. The first ring lies under level 0, too. Of servers that say
  /// ServerLimits::view_horizon.
  bool horizon = false;
  /// Equal Views ask for the same chunks in the same order.
  bool operator==(const View&) const = default;
};

/// Rings of levels 1 to 6 around `radius`, out to `farthest`, all wider than the one before by the same
/// ratio; fewer where radii that are whole would not grow.
[[nodiscard]] std::vector<LodRing> rings_between(std::uint16_t radius, std::uint16_t farthest);

/// Exactly the chunks that a server sends for a View: a box of level 0, and for each ring a box of its
/// level without the columns that the finer levels have whole (talus/voxel/view_shape.h).
class ViewShape {
 public:
  ViewShape() = default;  // no chunks
  /// REQUIRES: the View has no horizon.
  explicit ViewShape(const View& view);
  /// In a world of these heights (WorldInfo::heights()).
  ViewShape(const View& view, HeightRange heights);

  [[nodiscard]] bool covers(const ChunkKey& key) const;
  /// The rows of a column of `lod`; empty where the View does not have the column.
  [[nodiscard]] ChunkRange rows(std::int32_t x, std::int32_t z, Lod lod) const;
  /// Calls `visit(const ChunkKey&)` for every chunk, the finest level first.
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
  /// How many chunks there are, of all levels.
  [[nodiscard]] std::int64_t count() const;
  /// The same where the world's edge cuts none off: what Limits::view_chunks bounds.
  [[nodiscard]] std::uint64_t uncut_count() const { return uncut_count_; }

 private:
  std::vector<LevelBox> boxes_;
  std::uint64_t uncut_count_ = 0;
};

}  // namespace talus::client
