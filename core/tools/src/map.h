// Maps of the world from above, with relief shading.
#pragma once

#include <talus/map/edited_tops.h>
#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/tools/image.h>

#include <talus/progress/progress_bar.h>

namespace talus::tools {

struct MapOptions {
  int threads = 0;                         // 0: one per core
  int patch_edge = 256;                    // columns; affects speed and memory, never the picture
  const map::EditedTops* edits = nullptr;  // on top of the generated land; null: no edits
};

/// One pixel per column of `region`, north (low z) at the top. A pixel has the mean colour of the topmost
/// base voxel of its stack, so rock shows through thin soil, and the bed shows through shallow sea. Memory:
/// the picture, and a few patches per thread.
[[nodiscard]] Image render_map(const terrain::World& world, const terrain::Region& region,
                               const MapOptions& options, ProgressBar& progress);

}  // namespace talus::tools
