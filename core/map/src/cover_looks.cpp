#include "cover_looks.h"

#include <algorithm>

#include <talus/map/light.h>

namespace talus::map {
namespace {

using terrain::number_of;
using terrain::Quantity;
using terrain::QuantityNumber;

// Level ground has neither a slope nor a cliff.
bool of_slopes(QuantityNumber quantity) {
  return quantity == number_of(Quantity::slope) || quantity == number_of(Quantity::cliff);
}

}  // namespace

CoverLooks::CoverLooks(const terrain::World& world) : world_{world}, lights_{material_lights(world)} {
  const terrain::PlacesSpec& places = world.spec().places;
  place_of_.resize(terrain::kQuantities + places.fields.size());
  for (auto it = world.loose_bottom_up().rbegin(); it != world.loose_bottom_up().rend(); ++it) {
    const terrain::LooseSpec& loose = world.loose()[*it];
    covers_.push_back(
        {loose.material, static_cast<float>(loose.t_fx) / terrain::kSubvoxels, loose.S_fx, loose.share});
    if (!loose.share) continue;
    for (const terrain::PlaceRamp& ramp : places.shares[*loose.share].ramps) need(ramp.quantity);
  }
  std::int64_t top_q16 = 0;
  for (const terrain::StratumSpec& layer : world.strata()) {
    top_q16 += layer.thickness_q16;
    layer_tops_fx_.push_back((top_q16 * world.spec().resolution) >> 8);
  }
  for (std::size_t i = 1; i < places.looks.size(); ++i) {
    for (const terrain::LookCase& one : places.looks[i].cases) {
      for (const terrain::PlaceCondition& condition : one.conditions) need(condition.quantity);
    }
  }
}

void CoverLooks::need(QuantityNumber quantity) {
  if (place_of_[quantity] || of_slopes(quantity)) return;
  place_of_[quantity] = names_.size();
  names_.push_back(quantity < terrain::kQuantities
                       ? std::string{terrain::kQuantityNames[quantity]}
                       : world_.spec().places.fields[quantity - terrain::kQuantities].name);
}

float CoverLooks::value(const Place& place, QuantityNumber quantity) const {
  if (quantity == number_of(Quantity::slope)) return static_cast<float>(place.slope_fx);
  const auto& known = place_of_[quantity];
  return known ? place.samples.values[*known][place.column] : 0;
}

MaterialId CoverLooks::shown(const Place& place, MaterialId material) const {
  const terrain::World::ShownBy* const by = world_.shown_by(material);
  if (by == nullptr) return material;
  if (by->looks == 0) return by->by_look[place.samples.looks.values[place.column]];
  for (const terrain::LookCase& one : world_.spec().places.looks[by->looks].cases) {
    const bool holds = std::all_of(one.conditions.begin(), one.conditions.end(), [&](const auto& condition) {
      return (value(place, condition.quantity) >= condition.limit) == condition.above;
    });
    if (holds) return by->by_look[one.look];
  }
  return material;
}

float CoverLooks::voxels_of(const Place& place, const Cover& cover) const {
  const float flat = 1 - static_cast<float>(place.slope_fx) / static_cast<float>(cover.steepest_fx);
  if (flat <= 0) return 0;
  const float thickness = cover.thickness_voxels * flat;  // eq. 3
  if (!cover.share) return thickness;
  const terrain::ShareRule& rule = world_.spec().places.shares[*cover.share];
  if (((rule.looks >> place.samples.looks.values[place.column]) & 1U) == 0) return 0;
  double share = 1;
  for (const terrain::PlaceRamp& ramp : rule.ramps) {
    const double here = value(place, ramp.quantity);
    share *= std::clamp((here - ramp.none) / (ramp.all - ramp.none), 0.0, 1.0);
  }
  return thickness * static_cast<float>(share);
}

glm::vec3 CoverLooks::level_ground(const ColumnSamples& samples, std::size_t column) const {
  return covered({samples, column, 0}, world_.strata().back().material);
}

glm::vec3 CoverLooks::ground(const ColumnSamples& samples, std::size_t column, std::int32_t slope_fx) const {
  return covered({samples, column, slope_fx}, rock_at(samples.heights_fx.values[column]));
}

MaterialId CoverLooks::rock_at(std::int32_t height_fx) const {
  const auto layer = std::upper_bound(layer_tops_fx_.begin(), layer_tops_fx_.end() - 1, height_fx);
  return world_.strata()[static_cast<std::size_t>(layer - layer_tops_fx_.begin())].material;
}

glm::vec3 CoverLooks::covered(const Place& place, MaterialId rock) const {
  glm::vec3 sum{0};
  float left = 1;  // still uncovered part of the topmost voxel
  for (const Cover& cover : covers_) {
    const float part = std::min(left, voxels_of(place, cover));
    if (part > 0) sum += part * lights_[to_integer(shown(place, cover.material))];
    left -= part;
    if (left <= 0) return sum;
  }
  return sum + left * lights_[to_integer(rock)];
}

glm::vec3 CoverLooks::water(const ColumnSamples& samples, std::size_t column) const {
  return lights_[to_integer(shown({samples, column, 0}, kWater))];
}

}  // namespace talus::map
