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

/// What all figures draw: a world, and how.
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

/// In the order of the thesis; then what it has no figure of.
[[nodiscard]] std::span<const Figure> gallery_figures();

}  // namespace talus::tools
