// Light of the landscape: sun, sky, clouds and air. Pure functions of a direction.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace talus::cli {

/// Amount of cloud in a direction, 0 to 1: thin streaks on a plane high above.
[[nodiscard]] float cloud_cover(const glm::vec3& direction);

/// Light at the sun's elevation, from look.json; the sun's azimuth is the picture's choice. `to_sun` has
/// length 1.
struct Sky {
  glm::vec3 to_sun;
  glm::vec3 sunlight, zenith, horizon, glow;
  glm::vec3 from_above, from_below;  // on a face that looks up; reflected by the ground
  float exposure = 1.0F;

  explicit Sky(const glm::vec3& towards_sun = {0.0F, 1.0F, 0.0F});

  /// The sky without sun and clouds, to which distant land also fades.
  [[nodiscard]] glm::vec3 clear(const glm::vec3& direction) const {
    const float up = std::max(direction.y, 0.0F);
    glm::vec3 light = glm::mix(zenith, horizon, std::exp(-4.5F * up));
    light = glm::mix(light, horizon * 1.08F, 0.6F * std::exp(-16.0F * up));
    const float towards = glm::dot(direction, to_sun);
    const float low = std::exp(-5.0F * up);
    const float wide = std::pow(std::max(0.5F + 0.5F * towards, 0.0F), 6.0F);
    const float near = std::pow(std::max(towards, 0.0F), 24.0F);
    return light + glow * (wide * low * 0.55F + near * 0.35F * (0.35F + low));
  }

  [[nodiscard]] glm::vec3 seen(const glm::vec3& direction) const {
    const float towards = std::max(0.0F, glm::dot(direction, to_sun));
    const glm::vec3 sun =
        glm::vec3{1.0F, 0.86F, 0.62F} *
        (22.0F * glm::smoothstep(0.99955F, 0.99975F, towards) + 2.0F * std::pow(towards, 900.0F));
    const glm::vec3 cloud = sunlight * 0.42F + from_above * 0.5F;
    return glm::mix(clear(direction) + sun, cloud, cloud_cover(direction));
  }

  /// Light of the whole sky on a face.
  [[nodiscard]] glm::vec3 ambient(const glm::vec3& normal) const {
    return glm::mix(from_below, from_above, 0.5F + 0.5F * normal.y);
  }

  /// The colour to which distant land fades.
  [[nodiscard]] glm::vec3 haze(const glm::vec3& direction) const {
    return clear(glm::normalize(glm::vec3{direction.x, std::max(direction.y, 0.0F) + 0.012F, direction.z}));
  }
};

/// Maps light to the picture's range, 0 to 1, by a filmic curve (after Hill's fit of the ACES reference).
[[nodiscard]] glm::vec3 shown(const glm::vec3& light);

}  // namespace talus::cli
