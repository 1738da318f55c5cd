// One view at two levels of detail.
#pragma once

#include "gallery_figures.h"

namespace talus::tools {

inline constexpr int kLevelsPanelHeight = 640;

/// The same ground at level 0 and at level 4, by the chunks that a client would get.
[[nodiscard]] Expected<Image> draw_levels(const GalleryContext& context);

}  // namespace talus::tools
