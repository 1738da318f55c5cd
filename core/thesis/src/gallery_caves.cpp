#include "gallery_caves.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>

#include "isometric.h"
#include "palette.h"
#include "panels.h"
#include "plane_grid.h"
#include "world_variant.h"

namespace talus::tools {
namespace {

constexpr int kResolution = 150;
constexpr double kSide = 1.7;               // terrain units
constexpr int kPanelWidth = 1000;           // pixels
constexpr double kClearWaterUnits = 0.025;  // thickness of water that leaves 1/e of the light
constexpr int kPlacesAcross = 24;
constexpr int kPlacesPerSide = 6;

// A summed-area table of the plane: the sum over any rectangle takes four look-ups.
class Prefix {
 public:
  Prefix(int width, int depth) : width_{width}, sums_(static_cast<std::size_t>((width + 1) * (depth + 1))) {}
  void add(int x, int z, double value) { at(x + 1, z + 1) = value + at(x, z + 1) + at(x + 1, z) - at(x, z); }
  [[nodiscard]] double over(int x, int z, int width, int depth) {
    return at(x + width, z + depth) - at(x, z + depth) - at(x + width, z) + at(x, z);
  }

 private:
  double& at(int x, int z) { return sums_[static_cast<std::size_t>(z * (width_ + 1) + x)]; }
  int width_;
  std::vector<double> sums_;
};

// The rock removed by caves, without columns that are open to the sky.
VoxelGrid cast_of(const VoxelGrid& with, const terrain::Stacks& stacks, const VoxelGrid& rock) {
  VoxelGrid cast{with.width(), with.rows(), with.depth()};
  for (int z = 0; z < with.depth(); ++z) {
    for (int x = 0; x < with.width(); ++x) {
      if (stacks.is_entrance(x, z)) continue;
      for (int y = 0; y < with.rows(); ++y) {
        if (with.at(x, y, z) == kAir && is_solid(rock.at(x, y, z)))
          cast.fill(x, z, y, y + 1, rock.at(x, y, z));
      }
    }
  }
  return cast;
}

}  // namespace

terrain::Region cave_place(const terrain::World& world, int side) {
  const int step = std::max(1, side / kPlacesPerSide);
  const int across = step * kPlacesAcross;
  const terrain::Region all{-across / 2, -across / 2, across, across, Lod{}};
  const terrain::Stacks stacks = generate_stacks(world, all);
  Prefix air{across, across};
  Prefix open{across, across};
  Prefix height{across, across};
  for (int z = 0; z < across; ++z) {
    for (int x = 0; x < across; ++x) {
      const bool entrance = stacks.is_entrance(x, z);
      const bool roofed = !entrance && stacks.caves.has(x, z);
      air.add(x, z, roofed ? stacks.caves.roof.at(x, z) - stacks.caves.floor.at(x, z) : 0);
      open.add(x, z, entrance ? 1 : 0);
      height.add(x, z, stacks.tops.back().at(x, z));
    }
  }
  terrain::Region best{all.x, all.z, side, side, Lod{}};
  double most = -1;
  for (int z = 0; z + side <= across; z += step) {
    for (int x = 0; x + side <= across; x += step) {
      const double faces = air.over(x, z + side - 1, side, 1) + air.over(x + side - 1, z, 1, side);
      const double inside = air.over(x, z, side, side) / side;
      const double entrances = std::min(1.0, open.over(x, z, side, side) / (0.01 * side * side));
      const double back = height.over(x, z, side, side / 2) + height.over(x, z, side / 2, side);
      const double front =
          height.over(x, z + side / 2, side, side / 2) + height.over(x + side / 2, z, side / 2, side);
      const double slope = front > 0 ? std::clamp(back / front, 0.5, 1.5) : 1;
      const double score = (faces + inside) * (0.3 + entrances) * slope;
      if (score <= most) continue;
      most = score;
      best.x = all.x + x;
      best.z = all.z + z;
    }
  }
  return best;
}

Expected<Image> draw_caves(const GalleryContext& context) {
  const auto world = world_variant(context.text, {.resolution = kResolution});
  if (!world) return tl::make_unexpected(world.error());
  const terrain::Region region = cave_place(*world, static_cast<int>(kSide * kResolution));
  const terrain::Stacks stacks = generate_stacks(*world, region);
  const auto& tops = stacks.tops.back().values;
  const int rows = terrain::boundary_row(
      std::max(*std::max_element(tops.begin(), tops.end()), world->sea_fx().value_or(0)));
  const VoxelGrid block = grid_of_chunks(*world, region, 0, rows);
  const VoxelGrid rock = grid_of_planes(stacks.materials, stacks.tops, std::nullopt, 0, rows);
  const IsometricOptions options{.width = kPanelWidth,
                                 .height = kCavesPanelHeight,
                                 .threads = context.threads,
                                 .clear_water = static_cast<float>(kClearWaterUnits * kResolution)};
  const auto lights = material_lights(*world);
  const std::vector<Image> panels{
      render_isometric(block, lights, options, context.progress),
      render_isometric(cast_of(block, stacks, rock), lights, options, context.progress)};
  return join_panels(panels, 1);
}

}  // namespace talus::tools
