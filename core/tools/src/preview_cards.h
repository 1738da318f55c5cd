// The numbers of a preview, in columns side by side.
#pragma once

#include <vector>

#include <talus/terrain/world.h>

#include "canvas.h"
#include "preview_numbers.h"

namespace talus::tools {

/// From row `y` on, across the sheet; the row where they end.
[[nodiscard]] int draw_preview_cards(Canvas& canvas, int y, const terrain::World& world,
                                     const LandNumbers& land, const std::vector<NamedShare>& tops,
                                     const CostNumbers& cost);

}  // namespace talus::tools
