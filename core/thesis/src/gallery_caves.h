// The gallery's picture of caves.
#pragma once

#include "gallery_figures.h"

namespace talus::tools {

inline constexpr int kCavesPanelHeight = 700;  // pixels; there are two panels

/// Draws a block of a world cut open at its caves, next to the rock that they remove.
[[nodiscard]] Expected<Image> draw_caves(const GalleryContext& context);

/// The square of `side` columns at level 0, near the origin, whose south and east faces cut most caves, with
/// entrances in between.
[[nodiscard]] terrain::Region cave_place(const terrain::World& world, int side);

}  // namespace talus::tools
