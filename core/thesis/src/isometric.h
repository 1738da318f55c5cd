// Renders voxels: a block of terrain on a table, seen from the south-east and above.
#pragma once

#include <span>

#include <talus/tools/image.h>
#include <talus/tools/voxel_grid.h>
#include <glm/vec3.hpp>

#include <talus/progress/progress_bar.h>

namespace talus::tools {

struct IsometricOptions {
  int width = 1200;       // pixels
  int height = 900;       // pixels
  int threads = 0;        // 0: one per core
  int samples = 3;        // rays per pixel along each side
  float clear_water = 6;  // thickness of water, in voxels, that leaves 1/e of the light
};

/// Renders the whole box of the grid, fitted to the picture regardless of its contents, so that pictures of
/// equal boxes have one scale. Sun from the south-west, shadows, sky light by visibility of the sky, and
/// seams between voxels if they are large enough. `lights` are the materials' colours by id. The picture is
/// the same for any number of threads; progress counts rows of pixels, which the caller must expect.
[[nodiscard]] Image render_isometric(const VoxelGrid& grid, std::span<const glm::vec3> lights,
                                     const IsometricOptions& options, ProgressBar& progress);

}  // namespace talus::tools
