// How maps show colours: sun and sky on them, water over them.
#pragma once

#include <cstdint>

#include <talus/terrain/world.h>
#include <glm/vec3.hpp>

#include "relief.h"

namespace talus::map {

/// A colour of the ground under that light.
[[nodiscard]] glm::vec3 lit(glm::vec3 colour, Light light);

/// Water over its bed. Red light is lost first.
class WaterLight {
 public:
  explicit WaterLight(const terrain::World& world);
  /// What is seen of a lit bed through so many subvoxels, of level 0, of water of a colour; `light` falls on
  /// the water's surface.
  [[nodiscard]] glm::vec3 over(glm::vec3 bed, glm::vec3 water, std::int64_t depth_fx, Light light) const;

 private:
  glm::vec3 lost_a_subvoxel_;
  float darker_a_subvoxel_ = 0;
  float through_surface_ = 0;
};

/// As a picture shows it: bright light is compressed, so that slopes keep their colour instead of clipping,
/// and strong colours are softened.
[[nodiscard]] glm::vec3 developed(glm::vec3 light);

}  // namespace talus::map
