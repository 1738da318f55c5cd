#include "gallery_levels.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <talus/tools/voxel_grid.h>

#include "isometric.h"
#include "panels.h"
#include "world_variant.h"

namespace talus::tools {
namespace {

constexpr int kPanelWidth = 900;
constexpr int kResolution = 160;
constexpr double kSide = 7;  // terrain units
constexpr int kLevel = 4;
constexpr int kLevelSide = 1 << kLevel;

// Aligns a region of level 0 to columns of `kLevel`.
terrain::Region aligned(const terrain::Region& region) {
  const auto snapped = [](std::int64_t at) { return floor_div(at, kLevelSide) * kLevelSide; };
  const int side = region.width / kLevelSide * kLevelSide;
  return {snapped(region.x), snapped(region.z), side, side, Lod{}};
}

// `bottom` and `rows` in base voxels, multiples of kLevelSide.
Image draw_level(const GalleryContext& context, const terrain::World& world, const terrain::Region& base,
                 std::int32_t bottom, int rows, int level) {
  const terrain::Region region{base.x >> level, base.z >> level, base.width >> level, base.depth >> level,
                               Lod::of(level)};
  const VoxelGrid grid = grid_of_chunks(world, region, bottom >> level, rows >> level);
  const double clear_water = 0.025 * kResolution;  // as in the other figures
  return render_isometric(grid, material_lights(world),
                          {.width = kPanelWidth,
                           .height = kLevelsPanelHeight,
                           .threads = context.threads,
                           .clear_water = static_cast<float>(std::ldexp(clear_water, -level))},
                          context.progress);
}

}  // namespace

Expected<Image> draw_levels(const GalleryContext& context) {
  const auto world = world_variant(context.text, {.resolution = kResolution});
  if (!world) return tl::make_unexpected(world.error());
  const terrain::Region base = aligned(columns_of(scenic_place(*world, kSide), *world));
  const RowRange surface = rows_of_surface(*world, base);
  const auto snapped = [](std::int32_t row) {
    return static_cast<std::int32_t>(floor_div(row, kLevelSide)) * kLevelSide;
  };
  const std::int32_t bottom = snapped(surface.lowest_ground - kLevelSide);
  // Level 4 may be higher by one of its own voxels. The height is limited to twice the width.
  const int rows = std::min(snapped(surface.highest) + 2 * kLevelSide - bottom, 2 * base.width);
  std::vector<Image> panels;
  for (const int level : {0, kLevel}) {
    panels.push_back(draw_level(context, *world, base, bottom, rows, level));
  }
  return join_panels(panels, 2);
}

}  // namespace talus::tools
