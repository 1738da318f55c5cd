// Colours as light, in which they may be mixed and lit.
#pragma once

#include <span>
#include <vector>

#include <talus/terrain/world.h>
#include <glm/vec3.hpp>

namespace talus::map {

/// sRGB with its curve undone, 0 to 1.
[[nodiscard]] glm::vec3 to_light(terrain::Colour colour);
/// Clamps values outside 0 to 1.
[[nodiscard]] terrain::Colour to_colour(glm::vec3 light);

/// The colour of every material of a world as light, by id; and of `more`, whose ids lie beyond those.
[[nodiscard]] std::vector<glm::vec3> material_lights(const terrain::World& world,
                                                     std::span<const terrain::Material> more = {});

}  // namespace talus::map
