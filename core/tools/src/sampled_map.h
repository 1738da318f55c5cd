// The world from above and from afar: columns many base columns apart.
#pragma once

#include <talus/terrain/world.h>

#include <talus/map/column_grid.h>
#include <talus/progress/progress_bar.h>
#include "image.h"

namespace talus::tools {

struct SampledMapOptions {
  int threads = 0;       // 0: one a core
  int patch_edge = 512;  // columns; decides speed and memory, never a pixel
};

/// One pixel a column of the grid, north (low z) at the top. Light falls on the heights of the grid's
/// columns, which stand up the more the farther they lie apart. Where columns lie 16 base columns apart or
/// more and the world has looks, a colour is that of the look and of the loose material of level ground
/// there; else it is that of the top of the stack in the nearest level of detail.
[[nodiscard]] Image render_sampled_map(const terrain::World& world, const map::ColumnGrid& grid,
                                       const SampledMapOptions& options, ProgressBar& progress);

}  // namespace talus::tools
