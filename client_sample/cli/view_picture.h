// Draws a camera's view of the chunks that a client holds: a small ray caster.
#pragma once

#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/client/chunk_store.h>
#include <talus/client/world_info.h>

#include "picture.h"

namespace talus::cli {

struct Camera {
  glm::dvec3 position{};              // base voxels
  glm::dvec3 direction{};             // length 1, not straight up or down
  double field_of_view_degrees = 62;  // across the picture
};

/// Draws on two threads with 2 x 2 rays per pixel. `visible_voxels` is the extent of the chunks: haze hides
/// their end. Calls rows_done(rows) on the caller's thread with the number of newly drawn rows.
[[nodiscard]] Picture draw_view(const client::ChunkStore& store,
                                const std::vector<client::Material>& materials, const Camera& camera,
                                double visible_voxels, int width, int height,
                                const std::function<void(int)>& rows_done);

}  // namespace talus::cli
