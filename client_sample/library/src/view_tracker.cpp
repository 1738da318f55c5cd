#include "view_tracker.h"

#include <algorithm>

namespace talus::client {

std::vector<ChunkKey> ViewTracker::replace(const View& view) {
  view_ = view;
  shape_ = ViewShape{view};
  std::vector<ChunkKey> left;
  for (const auto& key : delivered_) {
    if (!shape_.covers(key)) left.push_back(key);
  }
  for (const auto& key : left) delivered_.erase(key);
  return left;
}

bool same_view(const View& a, const View& b) {
  const auto same_ring = [](const LodRing& p, const LodRing& q) {
    return p.lod == q.lod && p.radius == q.radius;
  };
  return a.centre == b.centre && a.direction == b.direction && a.horizontal_radius == b.horizontal_radius &&
         a.vertical_radius == b.vertical_radius &&
         std::equal(a.rings.begin(), a.rings.end(), b.rings.begin(), b.rings.end(), same_ring);
}

}  // namespace talus::client
