// Draws a shaded map of the ground, from above; north (smaller z) is up.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include <talus/client/world_info.h>

#include "picture.h"
#include "surface_map.h"

namespace talus::cli {

/// One pixel per column; extents wider or deeper than `kMaxMapSide` are drawn at every n-th column. `path` is
/// drawn as a white line through base columns (x, z). Unknown land is hatched in dark greys, with a darker
/// edge around known land.
inline constexpr std::int64_t kMaxMapSide = 4096;

[[nodiscard]] Picture draw_map(const SurfaceMap& surface, const std::vector<client::Material>& materials,
                               const Extent& extent, const std::vector<glm::dvec2>& path);

}  // namespace talus::cli
