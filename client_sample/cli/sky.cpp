#include "sky.h"

#include <cstdint>

namespace talus::cli {
namespace {

float corner(std::int64_t x, std::int64_t z) {
  auto bits = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U ^
              static_cast<std::uint64_t>(z) * 0xD6E8FEB86659FD93U;
  bits = (bits ^ (bits >> 32U)) * 0xD6E8FEB86659FD93U;
  return static_cast<float>((bits >> 40U) & 0xFFFFU) / 65535.0F;
}

// Values at whole points, smoothly joined.
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

float cloud_cover(const glm::vec3& direction) {
  constexpr int kOctaves = 5;
  if (direction.y <= 0.01F) return 0.0F;
  // Where the direction meets the plane; streaks lie along one axis.
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

}  // namespace talus::cli
