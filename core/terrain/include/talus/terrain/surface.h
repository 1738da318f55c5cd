// The height of the terrain (thesis 3.1): h = clamp(0.5 + gain * fBm, 0, 1)^exponent * amplitude.
#pragma once

#include <cstdint>
#include <span>

#include <talus/terrain/fbm.h>
#include <talus/terrain/world.h>

namespace talus::terrain {

/// The surface of a spec in the numbers it is computed with.
struct Surface {
  Fbm noise;
  float gain = 0;
  int exponent = 1;
  float highest_fx = 0;  // amplitude * resolution in subvoxels
};

[[nodiscard]] Surface surface_of(const WorldSpec& spec);

/// H in subvoxels at all (x, z) of two ascending lists of base columns, as sample_fbm orders them. H lies
/// between 0 and highest_fx, rounded. From here on everything is integer.
void sample_surface(const Surface& surface, std::span<const std::int64_t> xs,
                    std::span<const std::int64_t> zs, std::span<std::int32_t> heights_fx);

}  // namespace talus::terrain
