// The light over the landscape: sun, sky, clouds and air. Pure functions of a direction.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace talus::cli {

/// How much cloud there is in a direction, 0 to 1: thin streaks on a plane high above.
[[nodiscard]] float cloud_cover(const glm::vec3& direction);

/// An afternoon sun; `azimuth` as a unit vector in the plane, so that a picture can have it at its side.
struct Sky {
  glm::vec3 to_sun{0.0F, 1.0F, 0.0F};
  glm::vec3 sunlight{1.9F, 1.62F, 1.22F};
  glm::vec3 zenith{0.10F, 0.25F, 0.62F};
  glm::vec3 horizon{0.62F, 0.74F, 0.86F};
  glm::vec3 from_above{0.44F, 0.56F, 0.74F};  // on a face that looks up
  glm::vec3 from_below{0.23F, 0.20F, 0.17F};  // thrown back by the ground

  [[nodiscard]] glm::vec3 seen(const glm::vec3& direction) const {
    const float up = std::max(direction.y, 0.0F);
    glm::vec3 light = glm::mix(horizon, zenith, 1.0F - std::exp(-4.5F * up));
    const float towards = std::max(0.0F, glm::dot(direction, to_sun));
    light += glm::vec3{1.0F, 0.72F, 0.42F} * (0.30F * std::pow(towards, 10.0F));
    light += glm::vec3{1.0F, 0.9F, 0.7F} * (0.35F * std::pow(towards, 160.0F));
    const float cover = cloud_cover(direction);
    light = glm::mix(light, glm::vec3{0.93F, 0.94F, 0.97F} + 0.25F * towards * sunlight, cover);
    return light + sunlight * ((1.0F - cover) * 2.0F * glm::smoothstep(0.99935F, 0.99965F, towards));
  }

  /// Light from the whole sky on a face.
  [[nodiscard]] glm::vec3 ambient(const glm::vec3& normal) const {
    return glm::mix(from_below, from_above, 0.5F + 0.5F * normal.y);
  }

  /// The colour that distance turns to.
  [[nodiscard]] glm::vec3 haze(const glm::vec3& direction) const {
    return seen(
        glm::normalize(glm::vec3{direction.x, std::max(direction.y, 0.0F) * 0.5F + 0.03F, direction.z}));
  }
};

}  // namespace talus::cli
