#include "voxel_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace talus::tools {
namespace {

constexpr int kDirections = 16;
constexpr std::size_t kRemembered = 1 << 14;
constexpr float kTurn = 6.28318531F;

struct Compass {
  std::array<glm::vec2, kDirections> directions;
  Compass() {
    for (int i = 0; i < kDirections; ++i) {
      const float angle = (static_cast<float>(i) + 0.5F) * kTurn / kDirections;
      directions[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
  }
};
const Compass kCompass;

glm::ivec3 whole(glm::vec3 vector) {
  return glm::ivec3{glm::round(vector)};
}

}  // namespace

glm::vec3 sun_direction(std::size_t which) {
  // A sunflower pattern fills a disc evenly for any number of samples.
  constexpr float kDisc = 0.05F;
  const float turn = static_cast<float>(which % 16) * 2.39996323F;
  const float radius = kDisc * std::sqrt((static_cast<float>(which % 16) + 0.5F) / 16);
  const glm::vec3 sun = glm::normalize(glm::vec3{-0.60F, 0.74F, 0.44F});
  return glm::normalize(sun + radius * glm::vec3{std::cos(turn), std::sin(turn) * 0.5F, std::sin(turn)});
}

FaceAxes face_axes(Face face) {
  switch (face) {
    case Face::up:
    case Face::down:
      return {{1, 0, 0}, {0, 0, 1}};
    case Face::east:
    case Face::west:
      return {{0, 0, 1}, {0, 1, 0}};
    case Face::south:
    case Face::north:
      break;
  }
  return {{1, 0, 0}, {0, 1, 0}};
}

VoxelLight::VoxelLight(const VoxelRays& rays) : rays_{rays}, memory_(kRemembered) {
  const int side = std::max(rays.grid().width(), rays.grid().depth());
  for (int reach = 1, step = 1; reach <= std::max(10, side / 7); reach += step) {
    reaches_.push_back(reach);
    step = std::max(1, reach / 2);
  }
}

float VoxelLight::sky(const RayHit& hit) {
  const auto bits = [](int value) { return static_cast<std::uint64_t>(value); };
  const std::uint64_t key = ((bits(hit.voxel.x) << 40) | (bits(hit.voxel.z) << 20) | bits(hit.voxel.y)) * 8 +
                            static_cast<std::uint64_t>(hit.face);
  CachedSky& remembered = memory_[(key * 0x9E3779B97F4A7C15U) >> 50];
  if (remembered.key != key) remembered = {key, measure_sky(hit)};
  return remembered.sky;
}

float VoxelLight::measure_sky(const RayHit& hit) const {
  const glm::vec3 normal = normal_of(hit.face);
  const glm::vec3 centre = glm::vec3{hit.voxel} + 0.5F + normal * 0.6F;
  const bool level = hit.face == Face::up;
  float seen = 0;
  float weights = 0;
  for (const glm::vec2 direction : kCompass.directions) {
    const float turned = level ? 1 : direction.x * normal.x + direction.y * normal.z;
    if (turned <= 0) continue;
    float tangent = 0;
    for (const int reach : reaches_) {
      const float x = centre.x + direction.x * static_cast<float>(reach);
      const float z = centre.z + direction.y * static_cast<float>(reach);
      const int top = rays_.top(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(z)));
      // Distant columns have less weight, or the end of `reaches_` would show as a line.
      const float fade = 1 - 0.6F * static_cast<float>(reach) / static_cast<float>(reaches_.back());
      tangent = std::max(tangent, (static_cast<float>(top) - centre.y) / static_cast<float>(reach) * fade);
    }
    seen += turned / (1 + tangent * tangent);
    weights += turned;
  }
  if (weights == 0) return 0.15F;  // a face that looks down receives light only from the ground
  return (level ? 1.0F : 0.5F) * seen / weights;
}

float VoxelLight::corners(const RayHit& hit, glm::vec2 place) const {
  const FaceAxes axes = face_axes(hit.face);
  const glm::ivec3 outside = hit.voxel + whole(normal_of(hit.face));
  const auto closed = [&](int u, int v) {
    const glm::ivec3 at = outside + axes.u * u + axes.v * v;
    return rays_.solid_at(at.x, at.y, at.z) ? 1 : 0;
  };
  const auto openness = [&](int u, int v) {
    const int side_u = closed(u, 0);
    const int side_v = closed(0, v);
    const int covered = side_u + side_v + (side_u + side_v == 2 ? 1 : closed(u, v));
    return 1 - static_cast<float>(covered) / 3;
  };
  const float low = glm::mix(openness(-1, -1), openness(1, -1), place.x);
  const float high = glm::mix(openness(-1, 1), openness(1, 1), place.x);
  return glm::mix(low, high, place.y);
}

float VoxelLight::sun(glm::vec3 point, Face face, glm::vec3 to_sun) const {
  const glm::vec3 normal = normal_of(face);
  const float turned = glm::dot(normal, to_sun);
  if (turned <= 0) return 0;
  return rays_.blocked(point + normal * 2e-2F, to_sun) ? 0 : turned;
}

}  // namespace talus::tools
