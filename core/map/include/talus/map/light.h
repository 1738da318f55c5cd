// Colours as linear light, in which they can be mixed and lit.
#pragma once

#include <span>
#include <vector>

#include <talus/terrain/world.h>
#include <glm/vec3.hpp>

namespace talus::map {

/// Undoes the sRGB curve; channels are 0 to 1.
[[nodiscard]] glm::vec3 to_light(terrain::Colour colour);
/// Clamps values outside 0 to 1.
[[nodiscard]] terrain::Colour to_colour(glm::vec3 light);

/// The colours of all materials of a world as light, by id, and of `more`, whose ids lie beyond the world's.
[[nodiscard]] std::vector<glm::vec3> material_lights(const terrain::World& world,
                                                     std::span<const terrain::Material> more = {});

}  // namespace talus::map
