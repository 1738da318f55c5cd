#include "section_colours.h"

#include <cmath>

#include <talus/tools/image.h>
#include <glm/common.hpp>

namespace talus::tools {

terrain::Colour sky_colour(float down) {
  constexpr terrain::Colour kZenith{120, 164, 210};
  constexpr terrain::Colour kHorizon{222, 234, 240};
  return to_colour(glm::mix(to_light(kZenith), to_light(kHorizon), down));
}

float daylight_under(float depth_voxels) {
  return 0.6F + 0.8F * std::exp(-depth_voxels / 12);
}

}  // namespace talus::tools
