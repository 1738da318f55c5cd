// Draws a sheet that shows a world to its author.
#pragma once

#include <cstdint>
#include <string>

#include <talus/terrain/world.h>
#include <talus/tools/failure.h>
#include <talus/tools/image.h>

namespace talus::tools {

struct PreviewOptions {
  int threads = 0;  // 0: one per core
};

/// Maps at 1, 8 and 64 base columns per pixel around one base column, a section through it, the fields and
/// quantities of the largest map, and numbers. `name` is the sheet's heading. Fails if the largest map leaves
/// the world. Everything except the timings is reproducible.
[[nodiscard]] Expected<Image> draw_preview(const terrain::World& world, const std::string& name,
                                           std::int64_t x, std::int64_t z, const PreviewOptions& options);

}  // namespace talus::tools
