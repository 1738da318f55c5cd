#include "sky.h"

#include <cstdint>

#include <glm/mat3x3.hpp>

#include "look.h"
#include "picture.h"

namespace talus::cli {
namespace {

float corner(std::int64_t x, std::int64_t z) {
  auto bits = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U ^
              static_cast<std::uint64_t>(z) * 0xD6E8FEB86659FD93U;
  bits = (bits ^ (bits >> 32U)) * 0xD6E8FEB86659FD93U;
  return static_cast<float>((bits >> 40U) & 0xFFFFU) / 65535.0F;
}

// Random values at integer points, smoothly interpolated.
float value_noise(glm::vec2 at) {
  const glm::vec2 low = glm::floor(at);
  const glm::vec2 part = at - low;
  const glm::vec2 blend = part * part * (3.0F - 2.0F * part);
  const auto x = static_cast<std::int64_t>(low.x);
  const auto z = static_cast<std::int64_t>(low.y);
  return glm::mix(glm::mix(corner(x, z), corner(x + 1, z), blend.x),
                  glm::mix(corner(x, z + 1), corner(x + 1, z + 1), blend.x), blend.y);
}

}  // namespace

Sky::Sky(const glm::vec3& towards_sun) : to_sun{towards_sun} {
  const auto& keys = light_keys();
  std::size_t i = 0;
  while (i + 2 < keys.size() && to_sun.y > keys[i + 1].at) ++i;
  const LightKey& low = keys[i];
  const LightKey& high = keys[i + 1];
  const float part = glm::clamp((to_sun.y - low.at) / (high.at - low.at), 0.0F, 1.0F);
  const auto mixed = [&](LightColour LightKey::*colour) {
    const auto light = [&](const LightKey& key) { return to_light((key.*colour).rgb) * (key.*colour).times; };
    return glm::mix(light(low), light(high), part);
  };
  sunlight = mixed(&LightKey::sunlight);
  zenith = mixed(&LightKey::zenith);
  horizon = mixed(&LightKey::horizon);
  glow = mixed(&LightKey::glow);
  from_above = mixed(&LightKey::skylight);
  from_below = from_above * glm::vec3{0.42F, 0.36F, 0.28F} +
               sunlight * glm::vec3{0.075F, 0.065F, 0.045F} * (std::max(to_sun.y, 0.0F) + 0.2F);
  exposure = glm::mix(low.exposure, high.exposure, part);
}

float cloud_cover(const glm::vec3& direction) {
  constexpr int kOctaves = 5;
  if (direction.y <= 0.01F) return 0.0F;
  // Intersection of the direction with the plane; streaks lie along one axis.
  glm::vec2 at = glm::vec2{direction.x, direction.z} / (direction.y + 0.06F) * glm::vec2{1.1F, 0.55F};
  float sum = 0.0F;
  float amplitude = 0.5F;
  for (int octave = 0; octave < kOctaves; ++octave) {
    sum += amplitude * value_noise(at);
    at = at * 2.03F + glm::vec2{17.3F, 41.7F};
    amplitude *= 0.5F;
  }
  const float low_fade = glm::smoothstep(0.02F, 0.16F, direction.y);
  return 0.75F * low_fade * glm::smoothstep(0.46F, 0.74F, sum);
}

glm::vec3 shown(const glm::vec3& light) {
  const glm::mat3 to_rrt{0.59719F, 0.07600F, 0.02840F, 0.35458F, 0.90834F,
                         0.13383F, 0.04823F, 0.01566F, 0.83777F};
  const glm::mat3 from_odt{1.60475F,  -0.10208F, -0.00327F, -0.53108F, 1.10813F,
                           -0.07276F, -0.07367F, -0.00605F, 1.07602F};
  const glm::vec3 v = to_rrt * light;
  const glm::vec3 curved =
      (v * (v + 0.0245786F) - 0.000090537F) / (v * (0.983729F * v + 0.4329510F) + 0.238081F);
  return glm::clamp(from_odt * curved, 0.0F, 1.0F);
}

}  // namespace talus::cli
