#include "view/interest.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>

namespace talus::server {
namespace {

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

// A rank, from its highest bits: whole distance, angle, what is left of the distance, place.
constexpr int kPlaceBits = 24;
constexpr int kRestBits = 8;
constexpr int kAngleBits = 16;

}  // namespace

bool same_chunks(const View& a, const View& b) {
  const auto same_ring = [](const ViewRing& p, const ViewRing& q) {
    return p.lod == q.lod && p.radius == q.radius;
  };
  return a.centre == b.centre && a.horizontal_radius == b.horizontal_radius &&
         a.vertical_radius == b.vertical_radius &&
         std::equal(a.rings.begin(), a.rings.end(), b.rings.begin(), b.rings.end(), same_ring);
}

std::uint64_t count_chunks(const View& view) {
  std::uint64_t sum = 0;
  for (const Shell& shell : shells_of(view)) {
    const std::uint64_t columns = shell.x.size() * shell.z.size() - shell.hole_x.size() * shell.hole_z.size();
    sum += columns * shell.y.size();
  }
  return sum;
}

Interest::Interest(const View& view) : centre_{view.centre} {
  const float length = glm::length(view.direction);
  if (std::isfinite(length) && length > 0.0F) direction_ = view.direction / length;
  // A level's hole is at most a quarter of the level before it, so the boxes are at most 4/3 of the chunks.
  std::uint64_t places = 0;
  for (Shell shell : shells_of(view)) {
    shell.x = inside_world(shell.x, shell.lod);
    shell.y = inside_world(shell.y, shell.lod);
    shell.z = inside_world(shell.z, shell.lod);
    levels_.push_back({shell, static_cast<Place>(places)});
    places += shell.box_size();
  }
  assert(places <= Place{1} << kPlaceBits);
  places_ = static_cast<Place>(places);
}

std::optional<Interest::Place> Interest::place_of(ChunkKey key) const {
  const Level* const level = level_of(key.lod);
  const auto [x, y, z] = key.coord;
  if (level == nullptr || !level->shell.has_column(x, z) || !level->shell.y.contains(y)) return std::nullopt;
  return level->place_of(x, y, z);
}

const Interest::Level* Interest::level_of(Lod lod) const {
  for (const Level& level : levels_) {
    if (level.shell.lod == lod) return &level;
  }
  return nullptr;
}

glm::i64vec3 Interest::offset(ChunkKey key) const {
  const std::int64_t size = std::int64_t{1} << key.lod.value();
  const auto halves = [size](std::int64_t at, std::int64_t centre) {
    return (2 * at + 1) * size - (2 * centre + 1);
  };
  return {halves(key.coord.x, centre_.x), halves(key.coord.y, centre_.y), halves(key.coord.z, centre_.z)};
}

std::uint64_t Interest::rank(ChunkKey key, Place place) const {
  const glm::dvec3 to{offset(key)};
  const double distance = glm::length(to);
  const double cosine = distance > 0 ? std::clamp(glm::dot(direction_, to) / distance, -1.0, 1.0) : 1.0;

  constexpr double kAngleSteps = (1 << (kAngleBits - 1)) - 1;
  const auto angle = static_cast<std::uint64_t>((1.0 - cosine) * kAngleSteps);
  const auto distance_fx = static_cast<std::uint64_t>(distance / 2 * (1 << kRestBits));
  const std::uint64_t ring = distance_fx >> kRestBits;
  const std::uint64_t rest = distance_fx & ((1 << kRestBits) - 1);
  return (((ring << kAngleBits | angle) << kRestBits | rest) << kPlaceBits) | place;
}

std::uint64_t Interest::rough_rank(ChunkKey key, Place place) const {
  const glm::i64vec3 to = offset(key);
  return static_cast<std::uint64_t>(to.x * to.x + to.y * to.y + to.z * to.z) << kPlaceBits | place;
}

std::uint64_t Interest::end_of_ring(std::uint64_t rough_rank) {
  const double distance = std::sqrt(static_cast<double>(rough_rank >> kPlaceBits)) / 2;
  const auto next_ring = static_cast<std::uint64_t>(distance) + 1;
  return 4 * next_ring * next_ring << kPlaceBits;
}

std::pair<ChunkKey, Interest::Place> Interest::ranked(std::uint64_t rank) const {
  const auto place = static_cast<Place>(rank & ((std::uint64_t{1} << kPlaceBits) - 1));
  const auto after = std::find_if(levels_.begin(), levels_.end(),
                                  [place](const Level& level) { return level.first > place; });
  const Level& level = *std::prev(after);
  return {{level.shell.coord_of(place - level.first), level.shell.lod}, place};
}

}  // namespace talus::server
