// Which chunks a View wants, and in which order. Pure functions.
//
// Level 0 is a box: every chunk at most horizontal_radius away along x and z and vertical_radius along y.
// A ring of level l takes every chunk of that level that touches the columns at most `radius` base chunks
// away and the rows of the box, but for those whose columns the finer levels cover whole: the coarse
// chunks close the gap to the finer ones, and may overlap them at the edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/voxel/coords.h>

namespace talus::server {

struct ViewRing {
  Lod lod;
  int radius = 0;  // base chunks
  bool operator==(const ViewRing&) const = default;
};

struct View {
  glm::i64vec3 centre{};  // the base chunk around which the player is; anywhere, in the world or not
  glm::vec3 direction{};  // zero, or anything that is not finite: no preference
  int horizontal_radius = 0;
  int vertical_radius = 0;
  std::vector<ViewRing> rings;  // levels and radii growing
};

/// How many chunks the view has where the world's edge cuts none off. Costs nothing.
[[nodiscard]] std::uint64_t count_chunks(const View& view);

/// The view's chunks inside the world. By the distance of their centres in whole base chunks, nearest
/// first; at the same distance what lies in the view direction first.
[[nodiscard]] std::vector<ChunkKey> chunks_in_view(const View& view);

}  // namespace talus::server
