// A shaded map of the ground, from above; north (smaller z) is up.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include <talus/client/world_info.h>

#include "picture.h"
#include "surface_map.h"

namespace talus::cli {

/// A pixel a column; extents wider or deeper than `kMaxMapSide` are drawn at every n-th column. `path`
/// is drawn as a white line through base columns (x, z). What no chunk has shown is hatched in dark greys,
/// with a darker edge around what is known.
inline constexpr std::int64_t kMaxMapSide = 4096;

[[nodiscard]] Picture draw_map(const SurfaceMap& surface, const std::vector<client::Material>& materials,
                               const Extent& extent, const std::vector<glm::dvec2>& path);

}  // namespace talus::cli
