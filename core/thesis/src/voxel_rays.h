// Intersects straight lines with a grid of voxels.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <talus/tools/voxel_grid.h>
#include <talus/voxel/material.h>
#include <glm/vec3.hpp>

namespace talus::tools {

/// A side of a voxel, named by its outward direction.
enum class Face : std::uint8_t { up, down, east, west, south, north };

[[nodiscard]] glm::vec3 normal_of(Face face);

struct RayHit {
  float distance = 0;  // along the ray, in lengths of its direction
  glm::ivec3 voxel{0};
  Face face = Face::up;
};

/// The first solid voxel, and the water entered before it.
struct Sight {
  std::optional<RayHit> water;
  std::optional<RayHit> solid;
};

/// Walks column by column, skipping most of them by their height. The grid must outlive this object.
class VoxelRays {
 public:
  explicit VoxelRays(const VoxelGrid& grid);

  [[nodiscard]] const VoxelGrid& grid() const { return *grid_; }
  /// Rows of a column up to its highest voxel that is not air; 0 outside the grid.
  [[nodiscard]] int top(int x, int z) const {
    if (x < 0 || z < 0 || x >= grid_->width() || z >= grid_->depth()) return 0;
    return tops_[static_cast<std::size_t>(z) * static_cast<std::size_t>(grid_->width()) +
                 static_cast<std::size_t>(x)];
  }
  [[nodiscard]] int highest() const { return highest_; }
  /// False outside the grid.
  [[nodiscard]] bool solid_at(int x, int y, int z) const {
    return y >= 0 && y < top(x, z) && is_solid(grid_->at(x, y, z));
  }

  /// REQUIRES: no component of `direction` is zero.
  [[nodiscard]] Sight see(glm::vec3 origin, glm::vec3 direction) const;
  /// True if the ray meets anything solid.
  [[nodiscard]] bool blocked(glm::vec3 origin, glm::vec3 direction) const;

 private:
  const VoxelGrid* grid_;
  std::vector<int> tops_;
  int highest_ = 0;
};

}  // namespace talus::tools
