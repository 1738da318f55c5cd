// The picture of what lies below the ground.
#pragma once

#include "gallery_figures.h"

namespace talus::tools {

inline constexpr int kCavesPanelHeight = 700;  // pixels; there are two panels

/// A block of a world with caves, cut where they show, and beside it the rock that they take away.
[[nodiscard]] Expected<Image> draw_caves(const GalleryContext& context);

/// The square of `side` columns at level 0, near the origin, whose south and east faces cut most caves, with
/// entrances between them.
[[nodiscard]] terrain::Region cave_place(const terrain::World& world, int side);

}  // namespace talus::tools
