// Figures of the gallery: one function per figure, in one table.
#pragma once

#include <cstdint>
#include <span>

#include <talus/terrain/world.h>
#include <talus/tools/failure.h>
#include <talus/tools/image.h>
#include <talus/tools/world_file.h>

#include <talus/progress/progress_bar.h>
#include "gallery_place.h"

namespace talus::tools {

/// Input of every figure.
struct GalleryContext {
  const WorldText& text;        // to derive variants of the world
  const terrain::World& world;  // parsed from `text`
  int threads = 0;              // 0: one per core
  ProgressBar& progress;        // advanced for each row of pixels
};

struct Figure {
  const char* file;  // in the gallery's directory
  int pixel_rows;    // of all its panels together
  Expected<Image> (*draw)(const GalleryContext& context);
  bool of_caves = false;  // only for worlds with caves
};

/// All figures: the thesis' in its order, then additional ones.
[[nodiscard]] std::span<const Figure> gallery_figures();

}  // namespace talus::tools
