#include "feature.h"

#include <algorithm>

namespace talus::terrain {

std::unique_ptr<Carver> make_carver(const World& world, InstructionSet set) {
  for (const auto& feature : world.features()) {
    if (feature->carves()) return feature->make_carver(world, set);
  }
  return nullptr;
}

bool World::has_caves() const {
  return std::any_of(features_.begin(), features_.end(),
                     [](const auto& feature) { return feature->carves(); });
}

bool World::has_objects() const {
  return std::any_of(features_.begin(), features_.end(),
                     [](const auto& feature) { return feature->stands(); });
}

std::vector<ObjectKindName> World::object_kinds() const {
  for (const auto& feature : features_) {
    if (feature->stands()) return feature->object_kinds();
  }
  return {};
}

int World::feature_halo(Lod lod) const {
  int halo = 0;
  for (const auto& feature : features_) halo = std::max(halo, feature->halo(lod));
  return halo;
}

}  // namespace talus::terrain
