// A vertical cut across a wide land, with its heights drawn larger than its widths.
#pragma once

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include <talus/progress/progress_bar.h>
#include "image.h"

namespace talus::tools {

struct ProfileRows {
  int low = 0;   // base voxel row at the lower edge
  int rows = 0;  // pixels
  int step = 1;  // base voxels a pixel, upward
};

/// `line` is one column of some level deep. A pixel is one of its columns wide. Layers, loose material and
/// water as the stacks of that level have them, without what features put into rock.
[[nodiscard]] Image render_profile(const terrain::World& world, const terrain::Region& line,
                                   const ProfileRows& rows, int threads, ProgressBar& progress);

}  // namespace talus::tools
