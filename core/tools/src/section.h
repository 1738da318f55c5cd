// A vertical cut that shows the layers.
#pragma once

#include <cstdint>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/tools/failure.h>
#include <talus/tools/image.h>

#include <talus/progress/progress_bar.h>

namespace talus::tools {

struct SectionOptions {
  int threads = 0;  // 0: one per core
  int scale = 1;    // pixels per voxel, along both sides
};

/// `line` is one column wide or one deep, at level 0; its lowest coordinate is at the left. Shows the chunks'
/// voxels from a few rows below y = 0 to a few above the highest surface. Fails if the picture exceeds the
/// limits of image.h.
[[nodiscard]] Expected<Image> render_section(const terrain::World& world, const terrain::Region& line,
                                             const SectionOptions& options, ProgressBar& progress);

}  // namespace talus::tools
