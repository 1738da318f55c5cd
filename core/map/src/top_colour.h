// The colour of the ground as seen from above.
#pragma once

#include <span>

#include <talus/terrain/stacks.h>
#include <talus/terrain/world.h>
#include <talus/voxel/material.h>
#include <glm/vec3.hpp>

namespace talus::map {

/// Returns the mean over the topmost base voxel of a column, so that rock shows through thin soil. `outcrops`
/// are exposed_overlays() of the stacks, `lights` the world's material_lights().
[[nodiscard]] glm::vec3 top_colour(const terrain::World& world, const terrain::Stacks& stacks,
                                   std::span<const MaterialId> outcrops, std::span<const glm::vec3> lights,
                                   int x, int z);

}  // namespace talus::map
