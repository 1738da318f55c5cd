// A vertical cut through a wide land, with exaggerated heights.
#pragma once

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/tools/image.h>

#include <talus/progress/progress_bar.h>

namespace talus::tools {

struct ProfileRows {
  int low = 0;   // base voxel row at the lower edge
  int rows = 0;  // pixels
  int step = 1;  // base voxels per pixel, upwards
};

/// `line` is one column deep, at any level; a pixel is one of its columns wide. Shows layers, loose material
/// and water of that level's stacks, without features inside rock.
[[nodiscard]] Image render_profile(const terrain::World& world, const terrain::Region& line,
                                   const ProfileRows& rows, int threads, ProgressBar& progress);

}  // namespace talus::tools
