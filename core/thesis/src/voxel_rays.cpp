#include "voxel_rays.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace talus::tools {
namespace {

constexpr int kNone = -1;

// The part of a ray inside the box below the highest voxel, and the axis along which it entered.
struct Inside {
  float from = 0;
  float to = 0;
  int axis = kNone;
};

Inside clip(const VoxelGrid& grid, int highest, glm::vec3 origin, glm::vec3 direction) {
  const glm::vec3 box{grid.width(), highest, grid.depth()};
  Inside inside{0, std::numeric_limits<float>::max(), kNone};
  for (int axis = 0; axis < 3; ++axis) {
    const float low = -origin[axis] / direction[axis];
    const float high = (box[axis] - origin[axis]) / direction[axis];
    if (std::min(low, high) > inside.from) {
      inside.from = std::min(low, high);
      inside.axis = axis;
    }
    inside.to = std::min(inside.to, std::max(low, high));
  }
  return inside;
}

// The face through which a ray with this direction enters a voxel along an axis.
Face entered(int axis, glm::vec3 direction) {
  if (axis == 0) return direction.x > 0 ? Face::west : Face::east;
  if (axis == 2) return direction.z > 0 ? Face::north : Face::south;
  return direction.y > 0 ? Face::down : Face::up;
}

// Calls meet(hit, material) for the voxels along the ray that are not air, until it returns false.
template <typename Meet>
void walk(const VoxelRays& rays, glm::vec3 origin, glm::vec3 direction, const Meet& meet) {
  const VoxelGrid& grid = rays.grid();
  const Inside inside = clip(grid, rays.highest(), origin, direction);
  if (inside.from >= inside.to) return;
  const glm::vec3 start = origin + direction * inside.from;
  int x = std::clamp(static_cast<int>(std::floor(start.x)), 0, grid.width() - 1);
  int z = std::clamp(static_cast<int>(std::floor(start.z)), 0, grid.depth() - 1);
  const int step_x = direction.x > 0 ? 1 : -1;
  const int step_z = direction.z > 0 ? 1 : -1;
  const float per_x = 1 / std::abs(direction.x);
  const float per_z = 1 / std::abs(direction.z);
  float next_x = (static_cast<float>(x + (step_x > 0 ? 1 : 0)) - origin.x) / direction.x;
  float next_z = (static_cast<float>(z + (step_z > 0 ? 1 : 0)) - origin.z) / direction.z;
  float here = inside.from;
  int axis = inside.axis;
  while (here < inside.to) {
    const float leave = std::min({next_x, next_z, inside.to});
    const int top = rays.top(x, z);
    const float y_here = origin.y + direction.y * here;
    const float y_leave = origin.y + direction.y * leave;
    if (std::min(y_here, y_leave) < static_cast<float>(top)) {
      // Offset slightly, so that a ray on a boundary begins in the row that it is about to cross.
      const float hair = direction.y > 0 ? 1e-4F : -1e-4F;
      int y = static_cast<int>(std::floor(y_here + (axis == 1 ? hair * 8 : hair)));
      const int last = static_cast<int>(std::floor(y_leave));
      const int step_y = direction.y > 0 ? 1 : -1;
      float distance = here;
      int by = axis;
      for (; step_y > 0 ? y <= last : y >= last; y += step_y) {
        if (y >= 0 && y < top) {
          const MaterialId material = grid.at(x, y, z);
          if (material != kAir &&
              !meet(RayHit{distance, {x, y, z}, by == kNone ? Face::up : entered(by, direction)}, material)) {
            return;
          }
        }
        distance = (static_cast<float>(y + (step_y > 0 ? 1 : 0)) - origin.y) / direction.y;
        by = 1;
      }
    }
    here = leave;
    if (next_x < next_z) {
      x += step_x;
      next_x += per_x;
      axis = 0;
      if (x < 0 || x >= grid.width()) return;
    } else {
      z += step_z;
      next_z += per_z;
      axis = 2;
      if (z < 0 || z >= grid.depth()) return;
    }
  }
}

}  // namespace

glm::vec3 normal_of(Face face) {
  constexpr std::array<std::array<float, 3>, 6> kNormals{
      {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}}};
  const auto& n = kNormals[static_cast<std::size_t>(face)];
  return {n[0], n[1], n[2]};
}

VoxelRays::VoxelRays(const VoxelGrid& grid) : grid_{&grid} {
  for (int z = 0; z < grid.depth(); ++z) {
    for (int x = 0; x < grid.width(); ++x) {
      const auto column = grid.column(x, z);
      int top = grid.rows();
      while (top > 0 && column[static_cast<std::size_t>(top - 1)] == kAir) --top;
      tops_.push_back(top);
      highest_ = std::max(highest_, top);
    }
  }
}

Sight VoxelRays::see(glm::vec3 origin, glm::vec3 direction) const {
  Sight sight;
  walk(*this, origin, direction, [&](const RayHit& hit, MaterialId material) {
    if (material == kWater) {
      if (!sight.water) sight.water = hit;
      return true;
    }
    sight.solid = hit;
    return false;
  });
  return sight;
}

bool VoxelRays::blocked(glm::vec3 origin, glm::vec3 direction) const {
  bool blocked = false;
  walk(*this, origin, direction, [&](const RayHit&, MaterialId material) {
    blocked = is_solid(material);
    return !blocked;
  });
  return blocked;
}

}  // namespace talus::tools
