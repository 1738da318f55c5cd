// How much light reaches the side of a voxel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "voxel_rays.h"

namespace talus::tools {

/// The direction to one of several suns that stand close together, so that shadows have soft edges.
[[nodiscard]] glm::vec3 sun_direction(std::size_t which);

/// For one thread at a time: remembers the faces that it saw last.
class VoxelLight {
 public:
  explicit VoxelLight(const VoxelRays& rays);

  /// 0 to 1: the part of the sky that a face sees over the terrain; a wall under open sky sees half.
  [[nodiscard]] float sky(const Meeting& meeting);
  /// 0 to 1: darker toward corners that other voxels close. `place` is where on the face, 0 to 1 along
  /// each of face_axes().
  [[nodiscard]] float corners(const Meeting& meeting, glm::vec2 place) const;
  /// 0 to 1: what the terrain above leaves of the sun's light at a point on a face.
  [[nodiscard]] float sun(glm::vec3 point, Face face, glm::vec3 to_sun) const;

 private:
  struct Remembered {
    std::uint64_t key = ~std::uint64_t{0};
    float sky = 0;
  };
  [[nodiscard]] float measure_sky(const Meeting& meeting) const;

  const VoxelRays& rays_;
  std::vector<int> reaches_;
  std::vector<Remembered> memory_;
};

/// The two directions that span a face, each toward growing coordinates.
struct FaceAxes {
  glm::ivec3 u{0};
  glm::ivec3 v{0};
};
[[nodiscard]] FaceAxes face_axes(Face face);

}  // namespace talus::tools
