#include <talus/client/view.h>

#include <algorithm>

namespace talus::client {
namespace {

// Chunks of `lod` that touch the base chunks within `radius` of `centre`, inside the world.
Span touching(std::int64_t centre, std::int64_t radius, Lod lod) {
  const std::int64_t limit = chunk_limit(lod);
  return {std::max((centre - radius) >> lod.value(), -limit),
          std::min((centre + radius) >> lod.value(), limit - 1)};
}

// Chunks of `lod` that lie wholly inside chunks `finer` of `finer_lod`.
Span covered(const Span& finer, Lod finer_lod, Lod lod) {
  const std::int64_t ratio = std::int64_t{1} << (lod.value() - finer_lod.value());
  return {floor_div(finer.first + ratio - 1, ratio), floor_div(finer.last + 1, ratio) - 1};
}

}  // namespace

ViewShape::ViewShape(const View& view) {
  const std::int64_t x = floor_div(view.centre.x, kChunkSize);
  const std::int64_t y = floor_div(view.centre.y, kChunkSize);
  const std::int64_t z = floor_div(view.centre.z, kChunkSize);
  Shell shell{Lod{},
              touching(x, view.horizontal_radius, Lod{}),
              touching(y, view.vertical_radius, Lod{}),
              touching(z, view.horizontal_radius, Lod{}),
              {},
              {}};
  shells_.push_back(shell);
  for (const auto& ring : view.rings) {
    const Shell& finer = shells_.back();
    shell = {ring.lod,
             touching(x, ring.radius, ring.lod),
             touching(y, view.vertical_radius, ring.lod),
             touching(z, ring.radius, ring.lod),
             covered(finer.x, finer.lod, ring.lod),
             covered(finer.z, finer.lod, ring.lod)};
    shells_.push_back(shell);
  }
}

Span ViewShape::rows(std::int32_t x, std::int32_t z, Lod lod) const {
  const auto shell = std::find_if(shells_.begin(), shells_.end(),
                                  [&](const Shell& candidate) { return candidate.lod == lod; });
  if (shell == shells_.end() || !shell->x.contains(x) || !shell->z.contains(z)) return {};
  if (shell->hole_x.contains(x) && shell->hole_z.contains(z)) return {};
  return shell->y;
}

bool ViewShape::covers(const ChunkKey& key) const {
  return rows(key.coord.x, key.coord.z, key.lod).contains(key.coord.y);
}

std::int64_t ViewShape::count() const {
  std::int64_t sum = 0;
  for (const auto& shell : shells_) {
    sum += (shell.x.size() * shell.z.size() - shell.hole_x.size() * shell.hole_z.size()) * shell.y.size();
  }
  return sum;
}

}  // namespace talus::client
