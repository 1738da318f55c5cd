// The chunks of a View that lie in the world, numbered and in the order of their priority. No I/O. Which
// chunks those are says talus/voxel/view_shape.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

namespace talus::server {

struct View {
  glm::i64vec3 centre{};  // the base chunk around which the player is; anywhere, in the world or not
  glm::vec3 direction{};  // zero, or anything that is not finite: no preference
  int horizontal_radius = 0;
  int vertical_radius = 0;
  std::vector<ViewRing> rings;  // levels and radii growing
  std::uint32_t number = 0;     // the client's; 0: none
  /// The world's heights, where the View has a horizon.
  std::optional<HeightRange> horizon = std::nullopt;
};

/// Whether both have the same chunks, whatever their order and number.
[[nodiscard]] bool same_chunks(const View& a, const View& b);

/// How many chunks the View has where the world's edge cuts none off. Costs nothing.
[[nodiscard]] std::uint64_t count_chunks(const View& view);

/// A View's chunks inside the world, as boxes: nothing is stored for a single chunk. Each chunk has a place,
/// a number of its own, so that what is known of it fits into an array.
class AreaOfInterest {
 public:
  using Place = std::uint32_t;

  AreaOfInterest() = default;  // no chunks
  /// The View has at most 2^23 chunks.
  explicit AreaOfInterest(const View& view);

  /// Of each level, cut off at the world's edge.
  [[nodiscard]] std::vector<LevelBox> boxes() const;
  /// More than any place; at most twice as many as there are chunks.
  [[nodiscard]] std::size_t places() const { return places_; }
  [[nodiscard]] std::optional<Place> place_of(ChunkKey key) const;

  /// The rows of the level of `key`, which the View wants.
  [[nodiscard]] ChunkRange rows_of(ChunkKey key) const { return level_of(key.lod)->box.y; }

  /// Less for what is wanted sooner, and each chunk's own: by the distance of the centres in whole base
  /// chunks, the ring; then by the angle to the view direction; then by the exact distance. Chunks of a
  /// horizon that are 2^15 base chunks and more above or below count as so far.
  [[nodiscard]] std::uint64_t rank(ChunkKey key, Place place) const;
  /// Orders by distance alone, for a tenth of the cost; rings come one after the other, as in rank().
  [[nodiscard]] std::uint64_t coarse_priority(ChunkKey key, Place place) const;
  /// More than every coarse priority of the ring in which this one is, and no more than those beyond it.
  [[nodiscard]] static std::uint64_t end_of_ring(std::uint64_t coarse_priority);
  /// Whether the first chunk's centre is at most so many base chunks farther away than the second's.
  [[nodiscard]] bool within(ChunkKey chunk, ChunkKey nearest, int base_chunks) const;
  /// Whether the chunk is of the two nearest rings: of level 0, the 27 around the centre.
  [[nodiscard]] bool is_near(ChunkKey key) const;
  /// Calls visit(Place) for those of the area.
  template <typename Visit>
  void for_each_near(Visit&& visit) const {
    for (std::int64_t i = 0; i < 27; ++i) {
      const glm::i64vec3 at = centre_ + glm::i64vec3{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
      constexpr std::int64_t kEnd = std::int64_t{1} << 31;
      if (std::max({at.x, at.y, at.z}) >= kEnd || std::min({at.x, at.y, at.z}) < -kEnd) continue;
      const ChunkCoord coord{static_cast<std::int32_t>(at.x), static_cast<std::int32_t>(at.y),
                             static_cast<std::int32_t>(at.z)};
      if (const auto place = place_of({coord, Lod{}})) visit(*place);
    }
  }
  /// Of a rank or coarse priority.
  [[nodiscard]] static Place place_of_rank(std::uint64_t rank);
  /// The chunk whose rank or coarse priority it is, and its place.
  [[nodiscard]] std::pair<ChunkKey, Place> ranked(std::uint64_t rank) const;

  /// Where next_column() goes on.
  struct ColumnCursor {
    std::size_t level = 0;
    std::int64_t ring = 0;  // columns so far from the centre's, along x or along z
    std::int64_t step = 0;  // along the ring
  };
  /// The lowest chunk of the next column that has chunks; none after the last. Level by level, and in each
  /// the nearest first, by squares.
  [[nodiscard]] std::optional<ChunkKey> next_column(ColumnCursor& cursor) const;

  /// Calls visit(ChunkKey, Place) for every chunk, in no order that matters.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for (const Level& level : levels_) {
      const ChunkRange ys = level.box.y;
      level.box.for_each_column([&](std::int64_t x, std::int64_t z) {
        for (std::int64_t y = ys.first; y <= ys.last; ++y) {
          visit(ChunkKey{{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                          static_cast<std::int32_t>(z)},
                         level.box.lod},
                level.place_of(x, y, z));
        }
      });
    }
  }

  /// Calls visit(place, place in other, count) for every run of chunks that `other` and all of `between` want
  /// as well.
  template <typename Visit>
  void for_each_shared(const AreaOfInterest& other, std::span<const AreaOfInterest> between,
                       Visit&& visit) const {
    for (const Level& mine : levels_) {
      const Level* const theirs = other.level_of(mine.box.lod);
      if (theirs == nullptr) continue;
      ChunkRange ys = overlap(mine.box.y, theirs->box.y);
      for (const AreaOfInterest& each : between) {
        const Level* const level = each.level_of(mine.box.lod);
        ys = level == nullptr ? ChunkRange{} : overlap(ys, level->box.y);
      }
      if (ys.size() == 0) continue;
      mine.box.for_each_column([&](std::int64_t x, std::int64_t z) {
        if (!theirs->box.has_column(x, z)) return;
        for (const AreaOfInterest& each : between) {
          if (!each.level_of(mine.box.lod)->box.has_column(x, z)) return;
        }
        visit(mine.place_of(x, ys.first, z), theirs->place_of(x, ys.first, z), ys.size());
      });
    }
  }

 private:
  struct Level {
    LevelBox box;
    Place first;  // of the lowest corner of the outer box

    /// One more for the chunk above.
    [[nodiscard]] Place place_of(std::int64_t x, std::int64_t y, std::int64_t z) const {
      const auto from = [](ChunkRange range, std::int64_t at) {
        return static_cast<std::uint64_t>(at - range.first);
      };
      const std::uint64_t column = from(box.z, z) * box.x.size() + from(box.x, x);
      return static_cast<Place>(first + column * box.y.size() + from(box.y, y));
    }
    [[nodiscard]] ChunkCoord coord_of(Place place) const {
      const auto at = [](ChunkRange range, std::uint64_t offset) {
        return static_cast<std::int32_t>(range.first + static_cast<std::int64_t>(offset));
      };
      const std::uint64_t index = place - first;
      const std::uint64_t column = index / box.y.size();
      return {at(box.x, column % box.x.size()), at(box.y, index % box.y.size()),
              at(box.z, column / box.x.size())};
    }
  };

  [[nodiscard]] const Level* level_of(Lod lod) const;
  /// From the View's centre to the chunk's, in half base chunks, so that it is whole.
  [[nodiscard]] glm::i64vec3 offset(ChunkKey key) const;

  std::vector<Level> levels_;
  Place places_ = 0;
  glm::i64vec3 centre_{};
  glm::dvec3 direction_{};
};

}  // namespace talus::server
