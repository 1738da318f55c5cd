// Maps of the world from above at large scales: columns many base columns apart.
#pragma once

#include <talus/terrain/world.h>
#include <talus/tools/image.h>

#include <talus/map/column_grid.h>
#include <talus/progress/progress_bar.h>

namespace talus::tools {

struct SampledMapOptions {
  int threads = 0;       // 0: one per core
  int patch_edge = 512;  // columns; affects speed and memory, never the picture
};

/// One pixel per column of the grid, north (low z) at the top. Relief shading uses the heights of the grid's
/// columns, exaggerated with their distance. If columns are at least 16 base columns apart and the world has
/// looks, the look and the loose material of level ground there determine the colour; otherwise the top of
/// the stack in the nearest level of detail does.
[[nodiscard]] Image render_sampled_map(const terrain::World& world, const map::ColumnGrid& grid,
                                       const SampledMapOptions& options, ProgressBar& progress);

}  // namespace talus::tools
