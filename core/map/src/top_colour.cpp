#include "top_colour.h"

#include <algorithm>

namespace talus::map {

glm::vec3 top_colour(const terrain::World& world, const terrain::Stacks& stacks,
                     std::span<const MaterialId> outcrops, std::span<const glm::vec3> lights, int x, int z) {
  const MaterialId outcrop = outcrops[static_cast<std::size_t>(z * stacks.region.width + x)];
  const std::size_t strata = stacks.tops.size() - world.loose().size();
  const std::int32_t base_voxel_fx = terrain::kSubvoxels >> stacks.region.lod.value();
  std::int32_t top = stacks.ground_fx(x, z);
  const std::int32_t bottom = top - base_voxel_fx;
  glm::vec3 sum{0};
  for (std::size_t k = stacks.tops.size(); k-- > 0 && top > bottom;) {
    // The lowest plane's material extends downward without end.
    const std::int32_t under = k == 0 ? bottom : std::max(bottom, stacks.tops[k - 1].at(x, z));
    if (under >= top) continue;
    sum += static_cast<float>(top - under) *
           lights[to_integer(k < strata && outcrop != kAir ? outcrop : stacks.shown(world, k, x, z))];
    top = under;
  }
  return sum / static_cast<float>(base_voxel_fx);
}

}  // namespace talus::map
