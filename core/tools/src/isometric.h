// Voxels as a picture: a block of terrain on a table, seen from the south-east and above.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include <talus/progress/progress_bar.h>
#include "image.h"
#include "voxel_grid.h"

namespace talus::tools {

struct IsometricOptions {
  int width = 1200;       // pixels
  int height = 900;       // pixels
  int threads = 0;        // 0: one a core
  int samples = 3;        // rays a pixel along each side
  float clear_water = 6;  // voxels of water that leave 1/e of the light
};

/// The whole box of the grid, fitted to the picture, whatever it holds: pictures of equal boxes have one
/// scale. Sun from the south-west, shadows, light of the sky where the sky is seen, a seam between voxels
/// where they are large enough to be told apart. `lights` are the materials' colours by id. The same
/// picture for any number of threads; progress counts rows of pixels, which the caller expects.
[[nodiscard]] Image render_isometric(const VoxelGrid& grid, std::span<const glm::vec3> lights,
                                     const IsometricOptions& options, ProgressBar& progress);

}  // namespace talus::tools
