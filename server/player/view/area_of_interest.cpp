#include "player/view/area_of_interest.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>

namespace talus::server {
namespace {

ViewExtent extent_of(const View& view) {
  return {view.centre, view.horizontal_radius, view.vertical_radius, view.rings, view.horizon};
}

// The lowest bits of a rank; the others are the order's.
constexpr int kPlaceBits = 24;

}  // namespace

bool same_chunks(const View& a, const View& b) {
  return a.centre == b.centre && a.horizontal_radius == b.horizontal_radius &&
         a.vertical_radius == b.vertical_radius && a.rings == b.rings && a.horizon == b.horizon;
}

std::uint64_t count_chunks(const View& view) {
  return talus::count_chunks(level_boxes(extent_of(view), WorldEdge::ignored));
}

AreaOfInterest::AreaOfInterest(const View& view) : centre_{view.centre}, order_{view.centre, view.direction} {
  // A level's inner box has at most a quarter of the columns of the previous level, and at most one more row:
  // the inner boxes are at most half of the outer ones.
  std::uint64_t places = 0;
  for (const LevelBox& box : level_boxes(extent_of(view))) {
    levels_.push_back({box, static_cast<Place>(places)});
    places += box.x.size() * box.y.size() * box.z.size();
  }
  assert(places <= Place{1} << kPlaceBits);
  places_ = static_cast<Place>(places);
}

std::vector<LevelBox> AreaOfInterest::boxes() const {
  std::vector<LevelBox> boxes;
  for (const Level& level : levels_) boxes.push_back(level.box);
  return boxes;
}

std::optional<AreaOfInterest::Place> AreaOfInterest::place_of(ChunkKey key) const {
  const Level* const level = level_of(key.lod);
  if (level == nullptr || !level->box.contains(key.coord)) return std::nullopt;
  return level->place_of(key.coord.x, key.coord.y, key.coord.z);
}

const AreaOfInterest::Level* AreaOfInterest::level_of(Lod lod) const {
  for (const Level& level : levels_) {
    if (level.box.lod == lod) return &level;
  }
  return nullptr;
}

std::optional<ChunkKey> AreaOfInterest::next_column(ColumnCursor& cursor) const {
  for (; cursor.level < levels_.size(); cursor = {cursor.level + 1}) {
    const LevelBox& box = levels_[cursor.level].box;
    if (box.x.size() == 0 || box.y.size() == 0 || box.z.size() == 0) continue;
    const int lod = box.lod.value();
    const std::int64_t x = centre_.x >> lod;
    const std::int64_t z = centre_.z >> lod;
    const std::int64_t rings = std::max({x - box.x.first, box.x.last - x, z - box.z.first, box.z.last - z});
    for (; cursor.ring <= rings; ++cursor.ring, cursor.step = 0) {
      const std::int64_t radius = cursor.ring;
      while (cursor.step < std::max<std::int64_t>(1, 8 * radius)) {
        const std::int64_t side = radius == 0 ? 0 : cursor.step / (2 * radius);
        const std::int64_t along = cursor.step - 2 * radius * side - radius;
        ++cursor.step;
        const std::int64_t column_x = x + (side == 0   ? along
                                           : side == 1 ? radius
                                           : side == 2 ? -along
                                                       : -radius);
        const std::int64_t column_z = z + (side == 0   ? -radius
                                           : side == 1 ? along
                                           : side == 2 ? radius
                                                       : -along);
        if (!box.has_column(column_x, column_z)) continue;
        return ChunkKey{{static_cast<std::int32_t>(column_x), static_cast<std::int32_t>(box.y.first),
                         static_cast<std::int32_t>(column_z)},
                        box.lod};
      }
    }
  }
  return std::nullopt;
}

std::uint64_t AreaOfInterest::rank(ChunkKey key, Place place) const {
  return order_.rank(key) << kPlaceBits | place;
}

std::uint64_t AreaOfInterest::coarse_priority(ChunkKey key, Place place) const {
  const glm::i64vec3 to = order_.offset(key);
  return static_cast<std::uint64_t>(to.x * to.x + to.y * to.y + to.z * to.z) << kPlaceBits | place;
}

std::uint64_t AreaOfInterest::end_of_ring(std::uint64_t coarse_priority) {
  const double distance = std::sqrt(static_cast<double>(coarse_priority >> kPlaceBits)) / 2;
  const auto next_ring = static_cast<std::uint64_t>(distance) + 1;
  return 4 * next_ring * next_ring << kPlaceBits;
}

bool AreaOfInterest::within(ChunkKey chunk, ChunkKey nearest, int base_chunks) const {
  const double most = glm::length(glm::dvec3{order_.offset(nearest)}) + 2.0 * base_chunks;
  const glm::dvec3 to{order_.offset(chunk)};
  return glm::dot(to, to) <= most * most;
}

bool AreaOfInterest::is_near(ChunkKey key) const {
  const glm::i64vec3 to = order_.offset(key);  // in half chunks
  return key.lod == Lod{} && std::max({std::abs(to.x), std::abs(to.y), std::abs(to.z)}) <= 2;
}

AreaOfInterest::Place AreaOfInterest::place_of_rank(std::uint64_t rank) {
  return static_cast<Place>(rank & ((std::uint64_t{1} << kPlaceBits) - 1));
}

std::pair<ChunkKey, AreaOfInterest::Place> AreaOfInterest::ranked(std::uint64_t rank) const {
  const Place place = place_of_rank(rank);
  const auto after = std::find_if(levels_.begin(), levels_.end(),
                                  [place](const Level& level) { return level.first > place; });
  const Level& level = *std::prev(after);
  return {{level.coord_of(place), level.box.lod}, place};
}

}  // namespace talus::server
