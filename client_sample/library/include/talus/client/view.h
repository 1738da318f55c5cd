// What a player wants to have around it.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/voxel/coords.h>

namespace talus::client {

/// Coarser chunks around the view, out to `radius` base chunks.
struct LodRing {
  Lod lod;                   // 1 and up; each ring is coarser and farther out than the one before
  std::uint16_t radius = 0;  // base chunks
};

/// Chunks around a point: of level 0 within the radii, of coarser levels in the rings. The server sends
/// the nearest first, and what lies along `direction` before what lies behind.
struct View {
  VoxelPos centre;                      // base voxels
  glm::vec3 direction{0.0F};            // of any length; zero: no preference
  std::uint16_t horizontal_radius = 8;  // chunks
  std::uint16_t vertical_radius = 4;    // chunks
  std::vector<LodRing> rings;
};

/// Chunk coordinates along one axis, both ends included; empty where last < first.
struct Span {
  std::int64_t first = 0;
  std::int64_t last = -1;
  [[nodiscard]] bool contains(std::int64_t at) const { return first <= at && at <= last; }
  [[nodiscard]] std::int64_t size() const { return last < first ? 0 : last - first + 1; }
};

/// Exactly the chunks that a server sends for a View: a box of level 0, and for each ring a box of its
/// level without the columns that the finer levels cover whole (PROTOCOL.md, View).
class ViewShape {
 public:
  ViewShape() = default;  // no chunks
  explicit ViewShape(const View& view);

  [[nodiscard]] bool covers(const ChunkKey& key) const;
  /// The rows of a column of `lod`; empty where the View does not have the column.
  [[nodiscard]] Span rows(std::int32_t x, std::int32_t z, Lod lod) const;
  /// How many chunks there are, of all levels.
  [[nodiscard]] std::int64_t count() const;

 private:
  struct Shell {
    Lod lod;
    Span x, y, z;
    Span hole_x, hole_z;
  };
  std::vector<Shell> shells_;
};

}  // namespace talus::client
