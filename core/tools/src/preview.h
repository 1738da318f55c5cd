// One sheet that shows what a world is like, for its author.
#pragma once

#include <cstdint>
#include <string>

#include <talus/terrain/world.h>

#include "failure.h"
#include "image.h"

namespace talus::tools {

struct PreviewOptions {
  int threads = 0;  // 0: one a core
};

/// Maps at one, 8 and 64 base columns a pixel around one base column, a section through it, the fields and
/// quantities of the largest map, and numbers. `name` is the sheet's heading. Refused where the largest map
/// leaves the world. All but the seconds are the same each time.
[[nodiscard]] Expected<Image> draw_preview(const terrain::World& world, const std::string& name,
                                           std::int64_t x, std::int64_t z, const PreviewOptions& options);

}  // namespace talus::tools
