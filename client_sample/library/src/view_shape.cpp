#include <algorithm>

#include <talus/client/view.h>

namespace talus::client {
namespace {

ViewExtent extent_of(const View& view) {
  ViewExtent extent{{floor_div(view.centre.x, kChunkSize), floor_div(view.centre.y, kChunkSize),
                     floor_div(view.centre.z, kChunkSize)},
                    view.horizontal_radius,
                    view.vertical_radius,
                    {}};
  for (const LodRing& ring : view.rings) extent.rings.push_back({ring.lod, ring.radius});
  return extent;
}

}  // namespace

ViewShape::ViewShape(const View& view)
    : boxes_{level_boxes(extent_of(view))},
      uncut_count_{count_chunks(level_boxes(extent_of(view), WorldEdge::ignored))} {}

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
