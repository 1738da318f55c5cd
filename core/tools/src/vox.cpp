#include "vox.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <talus/tools/ordered_work.h>
#include <talus/tools/patch_grid.h>
#include <talus/tools/voxel_grid.h>

#include "vox_file.h"

namespace talus::tools {
namespace {

Expected<std::vector<terrain::Colour>> palette_of(const terrain::World& world) {
  const std::size_t colours = world.materials().size() - 1;  // air has no colour
  if (colours > kVoxColours) {
    return failed("--world: a .vox palette has " + std::to_string(kVoxColours) + " colours, the world has " +
                  std::to_string(colours) + " materials, water included; at most " +
                  std::to_string(kVoxColours - 1) + " besides water fit");
  }
  std::vector<terrain::Colour> palette;
  for (std::size_t id = 1; id <= colours; ++id) palette.push_back(world.materials()[id].colour);
  return palette;
}

// Divides a region into models of the format's size: patch by patch, each from the bottom up.
class ModelCutter {
 public:
  ModelCutter(const terrain::World& world, const terrain::Region& region, std::int32_t bottom,
              std::int32_t top)
      : world_{world},
        region_{region},
        grid_{region, kVoxModelSide},
        bottom_{bottom},
        top_{top},
        storeys_{static_cast<std::size_t>((top - bottom + kVoxModelSide - 1) / kVoxModelSide)} {}

  [[nodiscard]] std::size_t count() const { return grid_.count() * storeys_; }

  [[nodiscard]] VoxModel cut(std::size_t index) const {
    const terrain::Region patch = grid_.patch(index / storeys_);
    const std::int32_t floor = bottom_ + static_cast<std::int32_t>(index % storeys_) * kVoxModelSide;
    const int rows = std::min(kVoxModelSide, top_ - floor);
    VoxModel model;
    model.size = {patch.width, patch.depth, rows};
    model.corner = {patch.x - region_.x - region_.width / 2,
                    region_.z + region_.depth - (patch.z + patch.depth) - region_.depth / 2, floor - bottom_};
    model.name = std::to_string(patch.x) + " " + std::to_string(floor) + " " + std::to_string(patch.z);
    add_seen_voxels(patch, floor, model);
    return model;
  }

 private:
  void add_seen_voxels(const terrain::Region& patch, std::int32_t floor, VoxModel& model) const {
    // One extra voxel on each side that has a neighbour in the region.
    const auto west = static_cast<int>(std::min<std::int64_t>(1, patch.x - region_.x));
    const auto north = static_cast<int>(std::min<std::int64_t>(1, patch.z - region_.z));
    const bool at_east = patch.x + patch.width == region_.x + region_.width;
    const bool at_south = patch.z + patch.depth == region_.z + region_.depth;
    const terrain::Region around{patch.x - west, patch.z - north, patch.width + west + (at_east ? 0 : 1),
                                 patch.depth + north + (at_south ? 0 : 1), patch.lod};
    const VoxelGrid voxels = grid_of_chunks(world_, around, floor - 1, model.size.z + 2);
    for (int z = 0; z < patch.depth; ++z) {
      for (int x = 0; x < patch.width; ++x) {
        for (int y = 0; y < model.size.z; ++y) {
          const MaterialId material = voxels.at(x + west, y + 1, z + north);
          if (material == kAir || !seen(voxels, x + west, y + 1, z + north)) continue;
          model.voxels.push_back(
              {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(patch.depth - 1 - z),
               static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(to_integer(material))});
        }
      }
    }
  }

  // Water is visible next to air, rock next to either.
  static bool seen(const VoxelGrid& voxels, int x, int y, int z) {
    const bool solid = is_solid(voxels.at(x, y, z));
    const auto shows = [&](MaterialId beside) { return beside == kAir || (solid && beside == kWater); };
    if (x == 0 || x == voxels.width() - 1 || z == 0 || z == voxels.depth() - 1) return true;
    return shows(voxels.at(x, y + 1, z)) || shows(voxels.at(x, y - 1, z)) || shows(voxels.at(x - 1, y, z)) ||
           shows(voxels.at(x + 1, y, z)) || shows(voxels.at(x, y, z - 1)) || shows(voxels.at(x, y, z + 1));
  }

  const terrain::World& world_;
  const terrain::Region& region_;
  PatchGrid grid_;
  std::int32_t bottom_;
  std::int32_t top_;
  std::size_t storeys_;
};

RowRange rows_of_region(const terrain::World& world, const terrain::Region& region, int threads) {
  const PatchGrid grid{region, kVoxModelSide};
  RowRange rows = rows_of_surface(world, {region.x, region.z, 1, 1, region.lod});
  work_in_order(
      grid.count(), threads, [&](std::size_t index) { return rows_of_surface(world, grid.patch(index)); },
      [&](std::size_t, RowRange patch) {
        rows = rows.joined(patch);
        return true;
      });
  return rows;
}

}  // namespace

Expected<void> write_vox(const terrain::World& world, const terrain::Region& region,
                         const std::filesystem::path& target, const VoxOptions& options,
                         ProgressBar& progress) {
  const auto palette = palette_of(world);
  if (!palette) return tl::make_unexpected(palette.error());
  auto file = VoxFile::create(target);
  if (!file) return tl::make_unexpected(file.error());
  const int threads = thread_count(options.threads);
  const RowRange rows = rows_of_region(world, region, threads);
  const ModelCutter cutter{world, region, rows.lowest_ground - options.depth, rows.highest};
  progress.expect(cutter.count());
  Expected<void> outcome;
  work_in_order(
      cutter.count(), threads, [&](std::size_t index) { return cutter.cut(index); },
      [&](std::size_t, const VoxModel& model) {
        outcome = file->add(model);
        progress.advance(1);
        return outcome.has_value();
      });
  if (!outcome) return outcome;
  return file->finish(*palette, to_integer(kWater));
}

}  // namespace talus::tools
