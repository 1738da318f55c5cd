// Light on maps: sun and sky on the ground, and water over it.
#pragma once

#include <cstdint>

#include <talus/terrain/world.h>
#include <glm/vec3.hpp>

#include "relief.h"

namespace talus::map {

/// The colour of ground under `light`.
[[nodiscard]] glm::vec3 lit(glm::vec3 colour, Light light);

/// Light through water over its bed. Red is absorbed first.
class WaterLight {
 public:
  explicit WaterLight(const terrain::World& world);
  /// The light that leaves water of colour `water` over a lit bed. `depth_fx`: its depth in subvoxels of
  /// level 0. `light` falls on the water's surface.
  [[nodiscard]] glm::vec3 over(glm::vec3 bed, glm::vec3 water, std::int64_t depth_fx, Light light) const;

 private:
  glm::vec3 lost_a_subvoxel_;
  float darker_a_subvoxel_ = 0;
  float through_surface_ = 0;
};

/// Tone-maps light for display: compresses bright light, so that slopes keep their colour instead of
/// clipping, and softens strong colours.
[[nodiscard]] glm::vec3 developed(glm::vec3 light);

}  // namespace talus::map
