#include "map_light.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace talus::map {
namespace {

const glm::vec3 kMapSun{0.74F, 0.68F, 0.58F};
const glm::vec3 kMapSky{0.27F, 0.33F, 0.43F};
// Depth of water, in terrain units, at which 1/e of the light is left. Red is absorbed first.
const glm::vec3 kClearWater{0.012F, 0.024F, 0.032F};
// Share of light that passes the water's surface; below 1 so that shores show even in shallow water.
constexpr float kThroughSurface = 0.62F;
constexpr float kThroughRivers = 0.42F;  // with regions: rivers are shallow but must show from afar
// A terrain unit is about a metre with regions; with other surfaces it is as large as a mountain.
constexpr float kUnitsOfRegions = 110;
// With regions seas have shelves and deeps: water darkens with an e-folding depth of kDeepUnits terrain
// units, down to kDeepest of the light.
constexpr float kDeepUnits = 28;
constexpr float kDeepest = 0.42F;

}  // namespace

glm::vec3 lit(glm::vec3 colour, Light light) {
  return colour * (light.sun * kMapSun + light.sky * kMapSky);
}

WaterLight::WaterLight(const terrain::World& world) {
  const terrain::WorldSpec& spec = world.spec();
  const auto unit_fx = static_cast<float>(terrain::kSubvoxels * spec.resolution);
  const bool regions = spec.surface.regions.has_value();
  lost_a_subvoxel_ = 1.0F / (kClearWater * ((regions ? kUnitsOfRegions : 1.0F) * unit_fx));
  through_surface_ = regions ? kThroughRivers : kThroughSurface;
  if (regions) darker_a_subvoxel_ = 1.0F / (kDeepUnits * unit_fx);
}

glm::vec3 WaterLight::over(glm::vec3 bed, glm::vec3 water, std::int64_t depth_fx, Light light) const {
  const auto depth = static_cast<float>(depth_fx);
  const glm::vec3 through = through_surface_ * glm::exp(-depth * lost_a_subvoxel_);
  const float deep = kDeepest + (1 - kDeepest) * glm::exp(-depth * darker_a_subvoxel_);
  return lit(water, light) * deep * (1.0F - through) + bed * through;
}

glm::vec3 developed(glm::vec3 light) {
  const float grey = glm::dot(light, glm::vec3{0.2126F, 0.7152F, 0.0722F});
  const glm::vec3 calm = glm::mix(glm::vec3{grey}, light, 0.92F);
  return calm * 1.18F / (1.0F + 0.25F * calm);
}

}  // namespace talus::map
