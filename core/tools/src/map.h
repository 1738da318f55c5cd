// The world from above: materials as light falls on them.
#pragma once

#include <talus/map/edited_tops.h>
#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include <talus/progress/progress_bar.h>
#include "image.h"

namespace talus::tools {

struct MapOptions {
  int threads = 0;                         // 0: one a core
  int patch_edge = 256;                    // columns; decides speed and memory, never a pixel
  const map::EditedTops* edits = nullptr;  // over what is generated; null: none
};

/// One pixel a column of `region`, north (low z) at the top. A pixel's colour is the mean of the topmost
/// base voxel of its stack, so thin soil lets the rock shine through; the sea lets its bed shine through
/// where it is shallow. Memory: the picture, and some patches a thread.
[[nodiscard]] Image render_map(const terrain::World& world, const terrain::Region& region,
                               const MapOptions& options, ProgressBar& progress);

}  // namespace talus::tools
