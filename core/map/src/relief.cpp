#include "relief.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <talus/terrain/world.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace talus::map {
namespace {

constexpr std::array kReach{1, 2, 4, 7, 11, 16, kReliefRing};
constexpr float kSunTangent = 0.9F;  // tangent of its elevation angle
constexpr float kDiagonal = 1.41421356F;

struct Direction {
  int x;
  int z;
};
constexpr std::array kCompass{Direction{-1, -1}, Direction{0, -1}, Direction{1, -1}, Direction{-1, 0},
                              Direction{1, 0},   Direction{-1, 1}, Direction{0, 1},  Direction{1, 1}};
constexpr Direction kNorthWest = kCompass[0];

// Rises count less with distance, so that shadows do not break off where the ring ends.
float horizon_tangent(const terrain::Field& surface, int x, int z, Direction direction) {
  const float here = static_cast<float>(surface.at(x, z));
  const float stride = direction.x != 0 && direction.z != 0 ? kDiagonal : 1.0F;
  float steepest = 0;
  for (const int reach : kReach) {
    const float rise =
        static_cast<float>(surface.at(x + direction.x * reach, z + direction.z * reach)) - here;
    const float fade = 1 - static_cast<float>(reach - 1) / static_cast<float>(kReliefRing);
    steepest = std::max(steepest, rise / (terrain::kSubvoxels * stride * static_cast<float>(reach)) * fade);
  }
  return steepest;
}

// Eastward and southward rise per column of run, by Sobel weights over `reach` columns.
glm::vec2 gradient_at(const terrain::Field& surface, int x, int z, int reach) {
  const auto h = [&](int dx, int dz) {
    return static_cast<float>(surface.at(x + dx * reach, z + dz * reach));
  };
  const float east = (h(1, -1) + 2 * h(1, 0) + h(1, 1)) - (h(-1, -1) + 2 * h(-1, 0) + h(-1, 1));
  const float south = (h(-1, 1) + 2 * h(0, 1) + h(1, 1)) - (h(-1, -1) + 2 * h(0, -1) + h(1, -1));
  return glm::vec2{east, south} / static_cast<float>(8 * terrain::kSubvoxels * reach);
}

// Fine relief alone looks like crumpled foil; the coarse gradient adds the mountain's shape.
glm::vec3 normal_at(const terrain::Field& surface, int x, int z) {
  const glm::vec2 gradient = 0.55F * gradient_at(surface, x, z, 1) + 0.45F * gradient_at(surface, x, z, 9);
  return glm::normalize(glm::vec3{-gradient.x, 1, -gradient.y});
}

}  // namespace

Light light_at(const terrain::Field& surface, int x, int z) {
  const glm::vec3 sun = glm::normalize(glm::vec3{-1 / kDiagonal, kSunTangent, -1 / kDiagonal});
  const float turned = std::max(0.0F, glm::dot(normal_at(surface, x, z), sun)) / sun.y;
  const float over_horizon = horizon_tangent(surface, x, z, kNorthWest) - kSunTangent;
  const float shade = std::clamp(over_horizon / 0.5F + 0.5F, 0.0F, 1.0F);
  Light light;
  light.sun = turned * (1 - 0.85F * shade * shade * (3 - 2 * shade));
  light.sky = 0;
  for (const Direction direction : kCompass) {
    const float tangent = horizon_tangent(surface, x, z, direction);
    light.sky += 1 / (1 + tangent * tangent) / static_cast<float>(kCompass.size());
  }
  return light;
}

}  // namespace talus::map
