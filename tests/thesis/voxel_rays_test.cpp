#include "voxel_rays.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::tools;

namespace {

constexpr MaterialId kRock{2};

VoxelGrid random_grid() {
  VoxelGrid grid{*rc::gen::inRange(1, 7), *rc::gen::inRange(1, 7), *rc::gen::inRange(1, 7)};
  const int filled = *rc::gen::inRange(0, 20);
  for (int i = 0; i < filled; ++i) {
    const int y = *rc::gen::inRange(0, grid.rows());
    grid.fill(*rc::gen::inRange(0, grid.width()), *rc::gen::inRange(0, grid.depth()), y, y + 1,
              *rc::gen::element(kRock, kWater));
  }
  return grid;
}

// Odd fractions, so that no ray runs along an edge.
glm::vec3 random_vector(int reach) {
  const auto component = [&] { return static_cast<float>(*rc::gen::inRange(-reach, reach)) + 0.317F; };
  const float x = component();
  const float y = component();
  return {x * 0.91F, y * 0.83F, component() * 0.77F};
}

// Where a ray enters the cube of a voxel, by the cube's own three slabs.
std::optional<float> enters(glm::vec3 origin, glm::vec3 direction, glm::vec3 voxel) {
  float from = 0;
  float to = 1e9F;
  for (int axis = 0; axis < 3; ++axis) {
    const float low = (voxel[axis] - origin[axis]) / direction[axis];
    const float high = (voxel[axis] + 1 - origin[axis]) / direction[axis];
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  // A ray that cuts off a hair's breadth of an edge may be seen either way.
  if (to - from < 1e-3F) return std::nullopt;
  return from;
}

struct Nearest {
  float solid = 1e9F;
  float water = 1e9F;
};

Nearest by_all_voxels(const VoxelGrid& grid, glm::vec3 origin, glm::vec3 direction) {
  Nearest nearest;
  for (int z = 0; z < grid.depth(); ++z) {
    for (int x = 0; x < grid.width(); ++x) {
      for (int y = 0; y < grid.rows(); ++y) {
        const MaterialId material = grid.at(x, y, z);
        const auto distance = enters(origin, direction, {x, y, z});
        if (material == kAir || !distance) continue;
        float& least = material == kWater ? nearest.water : nearest.solid;
        least = std::min(least, *distance);
      }
    }
  }
  return nearest;
}

}  // namespace

TEST_CASE("A ray meets the solid voxel and the water that it would meet if all voxels were tried") {
  CHECK(rc::check([] {
    const VoxelGrid grid = random_grid();
    const VoxelRays rays{grid};
    const glm::vec3 origin = random_vector(14);
    const glm::vec3 direction = random_vector(5);
    const Nearest nearest = by_all_voxels(grid, origin, direction);
    const Sight sight = rays.see(origin, direction);
    const float solid = sight.solid ? sight.solid->distance : 1e9F;
    // Voxels that a ray only grazes are met by the walk and not by the slabs.
    RC_ASSERT(solid <= nearest.solid + 1e-3F);
    if (sight.solid) {
      const glm::ivec3 voxel = sight.solid->voxel;
      RC_ASSERT(is_solid(grid.at(voxel.x, voxel.y, voxel.z)));
      const auto entered = enters(origin, direction, voxel);
      RC_ASSERT(!entered || std::abs(*entered - solid) < 1e-3F);
      RC_ASSERT(rays.blocked(origin, direction));
    } else {
      RC_ASSERT(!rays.blocked(origin, direction));
    }
    if (nearest.water < nearest.solid - 1e-3F && nearest.water < solid) {
      RC_ASSERT(sight.water.has_value());
      RC_ASSERT(sight.water->distance <= nearest.water + 1e-3F);
    }
  }));
}

TEST_CASE("A ray names the face by which it comes in") {
  VoxelGrid grid{3, 3, 3};
  grid.fill(1, 1, 1, 2, kRock);
  const VoxelRays rays{grid};
  const glm::vec3 middle{1.5F, 1.5F, 1.5F};
  for (const Face face : {Face::up, Face::down, Face::east, Face::west, Face::south, Face::north}) {
    const glm::vec3 away = normal_of(face) * 5.0F + glm::vec3{0.1F, 0.13F, 0.07F};
    const Sight sight = rays.see(middle + away, -away);
    REQUIRE(sight.solid);
    CHECK(sight.solid->face == face);
  }
}
