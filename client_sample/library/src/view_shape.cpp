#include <algorithm>
#include <cassert>
#include <cmath>

#include <talus/client/view.h>

namespace talus::client {
namespace {

ViewExtent extent_of(const View& view, HeightRange heights) {
  ViewExtent extent{{floor_div(view.centre.x, kChunkSize), floor_div(view.centre.y, kChunkSize),
                     floor_div(view.centre.z, kChunkSize)},
                    view.horizontal_radius,
                    view.vertical_radius,
                    {}};
  for (const LodRing& ring : view.rings) extent.rings.push_back({ring.lod, ring.radius});
  if (view.horizon) extent.horizon = heights;
  return extent;
}

}  // namespace

std::vector<LodRing> rings_between(std::uint16_t radius, std::uint16_t farthest) {
  std::vector<LodRing> rings;
  const double ratio = static_cast<double>(farthest) / std::max<double>(1, radius);
  int before = radius;
  for (int level = 1; level <= Lod::kMax; ++level) {
    const double part = static_cast<double>(level) / Lod::kMax;
    const auto out = static_cast<int>(std::lround(std::max<double>(1, radius) * std::pow(ratio, part)));
    if (out <= before) continue;
    rings.push_back({Lod::of(level), static_cast<std::uint16_t>(out)});
    before = out;
  }
  return rings;
}

ViewShape::ViewShape(const View& view) : ViewShape{view, HeightRange{}} {
  assert(!view.horizon);
}

ViewShape::ViewShape(const View& view, HeightRange heights)
    : boxes_{level_boxes(extent_of(view, heights))},
      uncut_count_{count_chunks(level_boxes(extent_of(view, heights), WorldEdge::ignored))} {}

ChunkRange ViewShape::rows(std::int32_t x, std::int32_t z, Lod lod) const {
  const auto box =
      std::find_if(boxes_.begin(), boxes_.end(), [&](const LevelBox& level) { return level.lod == lod; });
  return box == boxes_.end() || !box->has_column(x, z) ? ChunkRange{} : box->y;
}

bool ViewShape::covers(const ChunkKey& key) const {
  return rows(key.coord.x, key.coord.z, key.lod).contains(key.coord.y);
}

std::int64_t ViewShape::count() const {
  return static_cast<std::int64_t>(count_chunks(boxes_));
}

}  // namespace talus::client
