// Computes the light on a voxel's face.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "voxel_rays.h"

namespace talus::tools {

/// Direction to one of several adjacent suns, which give shadows soft edges.
[[nodiscard]] glm::vec3 sun_direction(std::size_t which);

/// Not thread-safe: caches recent faces.
class VoxelLight {
 public:
  explicit VoxelLight(const VoxelRays& rays);

  /// 0 to 1: the part of the sky that a face sees above the terrain; 0.5 for a wall under open sky.
  [[nodiscard]] float sky(const RayHit& hit);
  /// 0 to 1: darker near corners that other voxels close. `place` is the position on the face, 0 to 1 along
  /// each of face_axes().
  [[nodiscard]] float corners(const RayHit& hit, glm::vec2 place) const;
  /// 0 to 1: the share of the sun's light that reaches a point on a face past the terrain above.
  [[nodiscard]] float sun(glm::vec3 point, Face face, glm::vec3 to_sun) const;

 private:
  struct CachedSky {
    std::uint64_t key = ~std::uint64_t{0};
    float sky = 0;
  };
  [[nodiscard]] float measure_sky(const RayHit& hit) const;

  const VoxelRays& rays_;
  std::vector<int> reaches_;
  std::vector<CachedSky> memory_;
};

/// The two axes of a face, both in positive directions.
struct FaceAxes {
  glm::ivec3 u{0};
  glm::ivec3 v{0};
};
[[nodiscard]] FaceAxes face_axes(Face face);

}  // namespace talus::tools
