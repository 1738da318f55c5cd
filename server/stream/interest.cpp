#include "stream/interest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace talus::server {
namespace {

/// Coordinates `first` to `last` along one axis; empty where last < first.
struct Span {
  std::int64_t first = 0;
  std::int64_t last = -1;

  [[nodiscard]] std::uint64_t size() const {
    return last < first ? 0 : static_cast<std::uint64_t>(last - first) + 1;
  }
  [[nodiscard]] bool contains(std::int64_t at) const { return first <= at && at <= last; }
};

/// Chunks of `level` that touch the base chunks within `radius` of `centre`.
Span touching(std::int64_t centre, int radius, int level) {
  return {(centre - radius) >> level, (centre + radius) >> level};
}

/// Chunks of `level` that lie wholly inside chunks `finer` of `finer_level`.
Span covered(Span finer, int finer_level, int level) {
  const std::int64_t begin = finer.first * (std::int64_t{1} << finer_level);
  const std::int64_t end = (finer.last + 1) * (std::int64_t{1} << finer_level);
  const std::int64_t size = std::int64_t{1} << level;
  return {floor_div(begin + size - 1, size), floor_div(end, size) - 1};
}

Span inside_world(Span span, Lod lod) {
  const std::int64_t limit = chunk_limit(lod);
  return {std::max(span.first, -limit), std::min(span.last, limit - 1)};
}

/// One level's chunks: a box without the columns of a smaller one.
struct Shell {
  Lod lod;
  Span x, y, z;
  Span hole_x, hole_z;
};

std::vector<Shell> shells_of(const View& view) {
  const int radius = view.horizontal_radius;
  std::vector<Shell> shells;
  shells.push_back({Lod{},
                    touching(view.centre.x, radius, 0),
                    touching(view.centre.y, view.vertical_radius, 0),
                    touching(view.centre.z, radius, 0),
                    {},
                    {}});
  for (const ViewRing& ring : view.rings) {
    const Shell& finer = shells.back();
    const int level = ring.lod.value();
    shells.push_back({ring.lod, touching(view.centre.x, ring.radius, level),
                      touching(view.centre.y, view.vertical_radius, level),
                      touching(view.centre.z, ring.radius, level), covered(finer.x, finer.lod.value(), level),
                      covered(finer.z, finer.lod.value(), level)});
  }
  return shells;
}

/// Sorts as the chunk is wanted: distance in whole base chunks, then the angle to the view direction, then
/// the exact distance.
class Rank {
 public:
  explicit Rank(const View& view) : centre_{view.centre} {
    const float length = glm::length(view.direction);
    if (std::isfinite(length) && length > 0.0F) direction_ = view.direction / length;
  }

  [[nodiscard]] std::uint64_t operator()(std::int64_t x, std::int64_t y, std::int64_t z, int level) const {
    // From centre to centre, in half base chunks, so that it is whole.
    const auto halves = [&](std::int64_t at, std::int64_t centre) {
      return (2 * at + 1) * (std::int64_t{1} << level) - (2 * centre + 1);
    };
    const glm::i64vec3 offset{halves(x, centre_.x), halves(y, centre_.y), halves(z, centre_.z)};
    const auto squared =
        static_cast<std::uint64_t>(offset.x * offset.x + offset.y * offset.y + offset.z * offset.z);
    const double distance = std::sqrt(static_cast<double>(squared));
    const double along = glm::dot(glm::dvec3{direction_}, glm::dvec3{offset});
    const double cosine = distance > 0 ? along / distance : 1.0;

    constexpr double kAngleSteps = 32767.0;
    const auto ring = static_cast<std::uint64_t>(distance / 2);
    const auto aside = static_cast<std::uint64_t>((1.0 - std::clamp(cosine, -1.0, 1.0)) * kAngleSteps);
    return (ring << 48) | (aside << 32) | std::min<std::uint64_t>(squared, 0xFFFF'FFFF);
  }

 private:
  glm::i64vec3 centre_;
  glm::vec3 direction_{};
};

}  // namespace

std::uint64_t count_chunks(const View& view) {
  std::uint64_t sum = 0;
  for (const Shell& shell : shells_of(view)) {
    const std::uint64_t columns = shell.x.size() * shell.z.size() - shell.hole_x.size() * shell.hole_z.size();
    sum += columns * shell.y.size();
  }
  return sum;
}

std::vector<ChunkKey> chunks_in_view(const View& view) {
  const Rank rank{view};
  std::vector<std::pair<std::uint64_t, ChunkKey>> ranked;
  ranked.reserve(static_cast<std::size_t>(count_chunks(view)));
  for (const Shell& shell : shells_of(view)) {
    const Span xs = inside_world(shell.x, shell.lod);
    const Span ys = inside_world(shell.y, shell.lod);
    const Span zs = inside_world(shell.z, shell.lod);
    for (std::int64_t z = zs.first; z <= zs.last; ++z) {
      for (std::int64_t x = xs.first; x <= xs.last; ++x) {
        if (shell.hole_x.contains(x) && shell.hole_z.contains(z)) continue;
        for (std::int64_t y = ys.first; y <= ys.last; ++y) {
          const ChunkCoord coord{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                                 static_cast<std::int32_t>(z)};
          ranked.emplace_back(rank(x, y, z, shell.lod.value()), ChunkKey{coord, shell.lod});
        }
      }
    }
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<ChunkKey> keys;
  keys.reserve(ranked.size());
  for (const auto& [order, key] : ranked) keys.push_back(key);
  return keys;
}

}  // namespace talus::server
