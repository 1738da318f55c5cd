// Colours of vertical cuts outside rock.
#pragma once

#include <talus/terrain/world.h>
#include <glm/vec3.hpp>

namespace talus::tools {

/// From the zenith, 0, to the horizon, 1.
[[nodiscard]] terrain::Colour sky_colour(float down);
/// Air in a cave; the sky's colours could be mistaken for an ore's.
inline constexpr terrain::Colour kUnderRoof{66, 60, 82};
/// Water darkens with depth.
[[nodiscard]] float daylight_under(float depth_voxels);

}  // namespace talus::tools
