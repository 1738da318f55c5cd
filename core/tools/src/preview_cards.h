// Numbers of a preview, in adjacent columns.
#pragma once

#include <vector>

#include <talus/terrain/world.h>

#include "canvas.h"
#include "preview_numbers.h"

namespace talus::tools {

/// Draws from row `y` across the sheet; returns the row at which the cards end.
[[nodiscard]] int draw_preview_cards(Canvas& canvas, int y, const terrain::World& world,
                                     const LandNumbers& land, const std::vector<NamedShare>& tops,
                                     const CostNumbers& cost);

}  // namespace talus::tools
