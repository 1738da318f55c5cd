// The gallery's picture of two levels of detail.
#pragma once

#include "gallery_figures.h"

namespace talus::tools {

inline constexpr int kLevelsPanelHeight = 640;

/// Draws the same ground at level 0 and at level 4, from the chunks that a client would receive.
[[nodiscard]] Expected<Image> draw_levels(const GalleryContext& context);

}  // namespace talus::tools
