// The height of the terrain (thesis 3.1): h = clamp(0.5 + gain * noise, 0, 1)^exponent * amplitude, or a
// height map's samples.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include <talus/terrain/fbm.h>
#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

namespace talus::terrain {

/// Displacement of a warped surface's noise: up to reach_fx subvoxels along each axis.
struct Warp {
  Fbm east;
  Fbm south;
  float reach_fx = 0;  // at most 2^22, so that adding 1.5 * 2^23 rounds a displacement
};

/// A height map placed in the endless plane. `_q16`: integers of 2^-16 voxel.
struct PlacedMap {
  std::shared_ptr<const Field> heights_fx;
  std::int64_t x_q16 = 0;  // of the first sample
  std::int64_t z_q16 = 0;
  std::int64_t spacing_x_q16 = 0;
  std::int64_t spacing_z_q16 = 0;
  Outside outside = Outside::mirror;
  std::int64_t margin_q16 = 0;
  SurfaceKind around = SurfaceKind::perlin;
};

struct Places;
struct Regions;

/// The surface of a spec, in the numbers used to compute it.
struct Surface {
  SurfaceKind kind = SurfaceKind::perlin;
  Fbm noise;
  float gain = 0;
  int exponent = 1;
  float highest_fx = 0;  // amplitude * resolution in subvoxels
  float feedback = 0;
  Warp warp;
  PlacedMap map;                           // only for height_map
  std::shared_ptr<const Regions> regions;  // only for regions
  std::shared_ptr<const Places> places;    // null if the world has neither looks nor shares
};

[[nodiscard]] Surface surface_of(const WorldSpec& spec);

/// Maximum H: highest_fx to the nearest integer, halves up.
[[nodiscard]] std::int32_t highest_height_fx(const Surface& surface);

/// Samples H in subvoxels at all (x, z) of two ascending lists of base columns, ordered as in sample_fbm. H
/// lies between 0 and highest_fx, rounded, and is a pure function of position. All later stages are integer.
void sample_surface(const Surface& surface, std::span<const std::int64_t> xs,
                    std::span<const std::int64_t> zs, std::span<std::int32_t> heights_fx);

}  // namespace talus::terrain
