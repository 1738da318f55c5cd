#include "cover_looks.h"

#include <algorithm>

#include "image.h"

namespace talus::tools {
namespace {

using terrain::number_of;
using terrain::Quantity;
using terrain::QuantityNumber;

// Level ground has neither.
bool of_slopes(QuantityNumber quantity) {
  return quantity == number_of(Quantity::slope) || quantity == number_of(Quantity::cliff);
}

}  // namespace

CoverLooks::CoverLooks(const terrain::World& world) : world_{world}, lights_{material_lights(world)} {
  const terrain::PlacesSpec& places = world.spec().places;
  place_of_.resize(terrain::kQuantities + places.fields.size());
  for (auto it = world.loose_bottom_up().rbegin(); it != world.loose_bottom_up().rend(); ++it) {
    const terrain::LooseSpec& loose = world.loose()[*it];
    covers_.push_back({loose.material, static_cast<float>(loose.t_fx) / terrain::kSubvoxels, loose.share});
    if (!loose.share) continue;
    for (const terrain::PlaceRamp& ramp : places.shares[*loose.share].ramps) need(ramp.quantity);
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

float CoverLooks::value(const ColumnSamples& samples, QuantityNumber quantity, std::size_t column) const {
  const auto& place = place_of_[quantity];
  return place ? samples.values[*place][column] : 0;
}

MaterialId CoverLooks::shown(const ColumnSamples& samples, MaterialId material, std::size_t column) const {
  const terrain::World::ShownBy* const by = world_.shown_by(material);
  if (by == nullptr) return material;
  if (by->looks == 0) return by->by_look[samples.looks.values[column]];
  for (const terrain::LookCase& one : world_.spec().places.looks[by->looks].cases) {
    const bool holds = std::all_of(one.conditions.begin(), one.conditions.end(), [&](const auto& condition) {
      return (value(samples, condition.quantity, column) >= condition.limit) == condition.above;
    });
    if (holds) return by->by_look[one.look];
  }
  return material;
}

float CoverLooks::voxels_of(const ColumnSamples& samples, const Cover& cover, std::size_t column) const {
  if (!cover.share) return cover.thickness_voxels;
  const terrain::ShareRule& rule = world_.spec().places.shares[*cover.share];
  if (((rule.looks >> samples.looks.values[column]) & 1U) == 0) return 0;
  double share = 1;
  for (const terrain::PlaceRamp& ramp : rule.ramps) {
    const double place = value(samples, ramp.quantity, column);
    share *= std::clamp((place - ramp.none) / (ramp.all - ramp.none), 0.0, 1.0);
  }
  return cover.thickness_voxels * static_cast<float>(share);
}

glm::vec3 CoverLooks::ground(const ColumnSamples& samples, std::size_t column) const {
  glm::vec3 sum{0};
  float left = 1;  // of the topmost voxel
  for (const Cover& cover : covers_) {
    const float part = std::min(left, voxels_of(samples, cover, column));
    if (part > 0) sum += part * lights_[to_integer(shown(samples, cover.material, column))];
    left -= part;
    if (left <= 0) return sum;
  }
  return sum + left * lights_[to_integer(world_.strata().back().material)];
}

glm::vec3 CoverLooks::water(const ColumnSamples& samples, std::size_t column) const {
  return lights_[to_integer(shown(samples, kWater, column))];
}

}  // namespace talus::tools
