#include "player/session/view_check.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "player/session/published_world.h"

namespace talus::server {
namespace {

using wire::ErrorCode;

/// Levels and radii must increase from ring to ring, starting from level 1 and the View's own radius.
tl::expected<std::vector<ViewRing>, Rejection> check_rings(const wire::View& view,
                                                           const SessionLimits& limits) {
  std::vector<ViewRing> rings;
  if (view.rings() == nullptr) return rings;
  if (view.rings()->size() > Lod::kMax) {
    return rejected(ErrorCode::too_large, fmt::format("View.rings has {} rings; levels 1 to {} are allowed",
                                                      view.rings()->size(), Lod::kMax));
  }
  int level = 0;
  int radius = view.horizontal_radius();
  for (const wire::LodRing* ring : *view.rings()) {
    if (ring->lod() <= level || ring->lod() > Lod::kMax || ring->radius() <= radius) {
      return rejected(
          ErrorCode::out_of_range,
          fmt::format(
              "View.rings: level {} with radius {} after level {} with radius {}; levels are 1 to {}, "
              "and both grow from ring to ring",
              ring->lod(), ring->radius(), level, radius, Lod::kMax));
    }
    level = ring->lod();
    radius = ring->radius();
    const int farthest = int{limits.view_horizontal_radius} << level;
    if (radius > farthest) {
      return rejected(
          ErrorCode::too_large,
          fmt::format("View.rings: radius {} of level {} is over the limit {}", radius, level, farthest));
    }
    rings.push_back({Lod::of(level), radius});
  }
  return rings;
}

}  // namespace

tl::expected<View, Rejection> check_view(const wire::View& view, const SessionLimits& limits,
                                         HeightRange heights) {
  if (view.centre() == nullptr) return rejected(ErrorCode::malformed, "View.centre is missing");
  if (view.has_base() && !limits.view_base) {
    return rejected(ErrorCode::unsupported, fmt::format("View.has_base: {}", kNotPublished));
  }
  if (view.horizontal_radius() > limits.view_horizontal_radius) {
    return rejected(ErrorCode::too_large,
                    fmt::format("View.horizontal_radius {} is over the limit view_horizontal_radius {}",
                                view.horizontal_radius(), limits.view_horizontal_radius));
  }
  if (view.vertical_radius() > limits.view_vertical_radius) {
    return rejected(ErrorCode::too_large,
                    fmt::format("View.vertical_radius {} is over the limit view_vertical_radius {}",
                                view.vertical_radius(), limits.view_vertical_radius));
  }
  auto rings = check_rings(view, limits);
  if (!rings) return tl::make_unexpected(std::move(rings).error());

  View checked;
  const wire::Voxel& centre = *view.centre();
  checked.centre = {floor_div(centre.x(), kChunkSize), floor_div(centre.y(), kChunkSize),
                    floor_div(centre.z(), kChunkSize)};
  if (view.direction() != nullptr) {
    checked.direction = {view.direction()->x(), view.direction()->y(), view.direction()->z()};
  }
  checked.horizontal_radius = view.horizontal_radius();
  checked.vertical_radius = view.vertical_radius();
  checked.rings = *std::move(rings);
  checked.number = view.number();
  checked.has_base = view.has_base();
  if (view.horizon()) checked.horizon = heights;
  if (const std::uint64_t chunks = count_chunks(checked); chunks > limits.view_chunks) {
    return rejected(ErrorCode::too_large, fmt::format("the View has {} chunks, over the limit view_chunks {}",
                                                      chunks, limits.view_chunks));
  }
  return checked;
}

}  // namespace talus::server
