// The pictures of the gallery: each is one function in one table.
#pragma once

#include <cstdint>
#include <span>

#include <talus/terrain/world.h>

#include <talus/progress/progress_bar.h>
#include "failure.h"
#include "gallery_place.h"
#include "image.h"
#include "world_file.h"

namespace talus::tools {

/// What every figure is given: the world, and how to draw it.
struct GalleryContext {
  const WorldText& text;        // for figures of the same world with a number changed
  const terrain::World& world;  // what it says
  int threads = 0;              // 0: one a core
  ProgressBar& progress;        // told of each row of pixels
};

struct Figure {
  const char* file;  // in the gallery's directory
  int pixel_rows;    // of all its panels together
  Expected<Image> (*draw)(const GalleryContext& context);
  bool of_caves = false;  // for worlds that have them
};

/// All figures: those of the thesis in its order, then those that it does not have.
[[nodiscard]] std::span<const Figure> gallery_figures();

}  // namespace talus::tools
