// A vertical cut that shows the layers.
#pragma once

#include <cstdint>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include <talus/progress/progress_bar.h>
#include "failure.h"
#include "image.h"

namespace talus::tools {

struct SectionOptions {
  int threads = 0;  // 0: one a core
  int scale = 1;    // pixels a voxel, along both sides
};

/// `line` is one column wide or one deep, at level 0; its lowest coordinate comes out on the left. Voxel
/// rows are those of the chunks. Cut from a few rows under y = 0 to a few above the highest surface.
/// Refused where the picture would pass the limits of image.h.
[[nodiscard]] Expected<Image> render_section(const terrain::World& world, const terrain::Region& line,
                                             const SectionOptions& options, ProgressBar& progress);

}  // namespace talus::tools
