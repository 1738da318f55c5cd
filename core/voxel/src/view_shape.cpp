#include <talus/voxel/view_shape.h>

namespace talus {
namespace {

/// Chunks of `level` that overlap the base chunks within `radius` of `centre`.
ChunkRange touching(std::int64_t centre, int radius, int level) {
  return {(centre - radius) >> level, (centre + radius) >> level};
}

/// Chunks of `level` entirely inside the chunks `finer` of `finer_level`.
ChunkRange wholly_inside(ChunkRange finer, int finer_level, int level) {
  const std::int64_t size = std::int64_t{1} << level;
  const std::int64_t begin = finer.first * (std::int64_t{1} << finer_level);
  const std::int64_t end = (finer.last + 1) * (std::int64_t{1} << finer_level);
  return {floor_div(begin + size - 1, size), floor_div(end, size) - 1};
}

/// Chunk rows of `level` that hold anything but one rock or air. The topmost ground voxel of a level may be
/// one voxel row lower than at level 0.
ChunkRange rows_of_world(HeightRange heights, int level) {
  constexpr std::int64_t kEdge = (std::int64_t{1} << 31) * kChunkSize;
  const std::int64_t low = std::clamp(heights.low, -kEdge, kEdge);
  const std::int64_t high = std::clamp(heights.high, -kEdge, kEdge);
  return {floor_div((low >> level) - 1, kChunkSize), floor_div((high - 1) >> level, kChunkSize)};
}

LevelBox cut_to_world(LevelBox box) {
  const std::int64_t limit = chunk_limit(box.lod);
  // The inner box too, so that count() can subtract it.
  for (ChunkRange* range : {&box.x, &box.y, &box.z, &box.inner_x, &box.inner_z}) {
    *range = overlap(*range, {-limit, limit - 1});
  }
  return box;
}

}  // namespace

std::uint64_t LevelBox::count() const {
  const std::uint64_t inner = overlap(x, inner_x).size() * overlap(z, inner_z).size();
  return (x.size() * z.size() - inner) * y.size();
}

std::vector<LevelBox> level_boxes(const ViewExtent& view, WorldEdge edge) {
  const auto outer = [&view](Lod lod, int radius) {
    const int level = lod.value();
    return LevelBox{lod,
                    touching(view.centre.x, radius, level),
                    touching(view.centre.y, view.vertical_radius, level),
                    touching(view.centre.z, radius, level),
                    {},
                    {}};
  };
  std::vector<LevelBox> boxes{outer(Lod{}, view.horizontal_radius)};
  for (const ViewRing& ring : view.rings) {
    const LevelBox& finer = boxes.back();
    LevelBox box = outer(ring.lod, ring.radius);
    if (view.horizon) box.y = rows_of_world(*view.horizon, ring.lod.value());
    if (!view.horizon || boxes.size() > 1) {  // level 0 does not contain all rows of its columns
      box.inner_x = wholly_inside(finer.x, finer.lod.value(), ring.lod.value());
      box.inner_z = wholly_inside(finer.z, finer.lod.value(), ring.lod.value());
    }
    boxes.push_back(box);
  }
  if (edge == WorldEdge::cuts) std::transform(boxes.begin(), boxes.end(), boxes.begin(), cut_to_world);
  return boxes;
}

std::uint64_t count_chunks(std::span<const LevelBox> boxes) {
  std::uint64_t sum = 0;
  for (const LevelBox& box : boxes) sum += box.count();
  return sum;
}

}  // namespace talus
