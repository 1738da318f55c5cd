// Writes a region as MagicaVoxel models.
#pragma once

#include <filesystem>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/tools/failure.h>

#include <talus/progress/progress_bar.h>

namespace talus::tools {

struct VoxOptions {
  int threads = 0;  // 0: one per core
  int depth = 24;   // voxels below the lowest ground; at least 1
};

/// Writes the voxels of the region's chunks, at any level, that have a face to air, to water or to one of the
/// region's four sides. Voxels that are invisible from above and from the sides are omitted, so the models
/// are hollow, and open below. East is x, north (low z) is y and up is z; the region's middle is at x = y =
/// 0, its lowest row at z = 0. Regions above 256 voxels a side become several models. A voxel's palette index
/// is its material's id. Memory: one model of voxels per thread.
[[nodiscard]] Expected<void> write_vox(const terrain::World& world, const terrain::Region& region,
                                       const std::filesystem::path& target, const VoxOptions& options,
                                       ProgressBar& progress);

}  // namespace talus::tools
