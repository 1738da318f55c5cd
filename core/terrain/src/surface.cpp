#include <talus/terrain/surface.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <talus/terrain/rounding.h>

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
  std::vector<float> noise(xs.size() * zs.size());
  sample_fbm(surface.noise, xs, zs, noise);
  for (std::size_t i = 0; i < noise.size(); ++i) {
    const float level = std::min(std::max(0.5F + surface.gain * noise[i], 0.0F), 1.0F);
    float power = level;
    for (int e = 1; e < surface.exponent; ++e) power *= level;
    heights_fx[i] = round_to_even(power * surface.highest_fx);
  }
}

}  // namespace talus::terrain
