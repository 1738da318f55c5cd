#include <talus/terrain/surface.h>

#include <cmath>

#include <talus/terrain/lattice_hash.h>

#include "place/places.h"
#include "spec/units.h"
#include "surface/regions/regions.h"
#include "surface/surface_rows.h"

namespace talus::terrain {
namespace {

Warp warp_of(const WorldSpec& spec) {
  const auto noise = [&](std::uint64_t axis) {
    // Separated from the seeds of the surface's octaves.
    return Fbm{derived_seed(spec.seed, 0x5741525000000000U + axis),
               rounded(spec.surface.warp_wavelength * spec.resolution), spec.surface.warp_octaves};
  };
  return {noise(0), noise(1), static_cast<float>(spec.surface.warp * spec.resolution * kSubvoxels)};
}

PlacedMap placed(const HeightMapSpec& map, int resolution) {
  const auto q16 = [&](double units) { return rounded(units * resolution * 65536.0); };
  return {map.heights_fx,     q16(map.x),  q16(map.z),      q16(map.spacing_x),
          q16(map.spacing_z), map.outside, q16(map.margin), map.around};
}

}  // namespace

Surface surface_of(const WorldSpec& spec) {
  const SurfaceSpec& s = spec.surface;
  Surface surface;
  surface.kind = s.kind;
  surface.noise.seed = spec.seed;
  surface.noise.period = rounded(s.wavelength * spec.resolution);
  surface.noise.octaves = s.octaves;
  surface.gain = static_cast<float>(s.gain);
  surface.exponent = s.exponent;
  surface.highest_fx = static_cast<float>(s.amplitude * spec.resolution * kSubvoxels);
  surface.feedback = static_cast<float>(s.feedback);
  if (s.noise() == SurfaceKind::warped) surface.warp = warp_of(spec);
  if (s.height_map) surface.map = placed(*s.height_map, spec.resolution);
  if (s.regions) {
    surface.regions = std::make_shared<const Regions>(
        regions_of(*s.regions, spec.places.fields, spec.seed, spec.resolution));
  }
  if (spec.places.any()) surface.places = std::make_shared<const Places>(places_of(spec.places));
  return surface;
}

std::int32_t highest_height_fx(const Surface& surface) {
  return static_cast<std::int32_t>(std::floor(surface.highest_fx + 0.5F));
}

void sample_surface(const Surface& surface, std::span<const std::int64_t> xs,
                    std::span<const std::int64_t> zs, std::span<std::int32_t> heights_fx) {
  const auto rows = make_surface_rows(surface, instruction_set());
  rows->start(xs);
  for (std::size_t j = 0; j < zs.size(); ++j) rows->row(zs[j], heights_fx.data() + j * xs.size());
}

}  // namespace talus::terrain
