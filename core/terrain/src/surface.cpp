#include <talus/terrain/surface.h>

#include <cmath>

#include "surface_rows.h"

namespace talus::terrain {

Surface surface_of(const WorldSpec& spec) {
  const SurfaceSpec& s = spec.surface;
  Surface surface;
  surface.noise.seed = spec.seed;
  surface.noise.period = static_cast<std::int64_t>(std::floor(s.wavelength * spec.resolution + 0.5));
  surface.noise.octaves = s.octaves;
  surface.gain = static_cast<float>(s.gain);
  surface.exponent = s.exponent;
  surface.highest_fx = static_cast<float>(s.amplitude * spec.resolution * kSubvoxels);
  return surface;
}

void sample_surface(const Surface& surface, std::span<const std::int64_t> xs,
                    std::span<const std::int64_t> zs, std::span<std::int32_t> heights_fx) {
  SurfaceRows rows{instruction_set()};
  rows.start(surface, xs);
  for (std::size_t j = 0; j < zs.size(); ++j) rows.row(zs[j], heights_fx.data() + j * xs.size());
}

}  // namespace talus::terrain
