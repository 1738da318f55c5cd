// The plan of caves, in the numbers used to compute them. Private to core/terrain.
#pragma once

#include <cstdint>

#include <talus/terrain/fbm.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {

/// Noise is converted to integers of this many parts.
inline constexpr std::int32_t kNoiseOne = 1 << 14;

/// `_noise`: in kNoiseOne parts of noise.
struct CavePlan {
  Fbm tunnels;
  Fbm chambers;
  Fbm climb;
  std::int32_t low_fx = 0;
  std::int32_t climb_fx = 0;  // from the lowest middle to the highest
  std::int32_t half_width_noise = 0;
  std::int32_t height_fx = 0;
  std::int32_t threshold_noise = 0;
  std::int32_t chamber_height_fx = 0;
  std::int32_t roof_fx = 0;
  int span = 0;  // columns of level 0

  /// Maximum span of a roof in columns of a level; 0 means that the level has no caves.
  [[nodiscard]] int span_at(Lod lod) const { return span >> lod.value(); }
};

}  // namespace talus::terrain
