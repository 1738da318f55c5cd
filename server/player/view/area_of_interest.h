// The chunks of a View inside the world, numbered and ordered by priority. No I/O. talus/voxel/view_shape.h
// defines the chunks of a View.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/voxel/coords.h>
#include <talus/voxel/view_order.h>
#include <talus/voxel/view_shape.h>

namespace talus::server {

struct View {
  glm::i64vec3 centre{};  // the player's base chunk; may be outside the world
  glm::vec3 direction{};  // zero or not finite: no preference
  int horizontal_radius = 0;
  int vertical_radius = 0;
  std::vector<ViewRing> rings;  // with increasing levels and radii
  std::uint32_t number = 0;     // assigned by the client; 0: unnumbered
  /// The world's heights if the View has a horizon.
  std::optional<HeightRange> horizon = std::nullopt;
  bool has_base = false;  // the client makes chunks: only edited ones are sent
};

/// Returns true if both have the same chunks, regardless of order, number and base.
[[nodiscard]] bool same_chunks(const View& a, const View& b);

/// Number of chunks of the View if the world's edge does not cut any off. Cheap.
[[nodiscard]] std::uint64_t count_chunks(const View& view);

/// A View's chunks inside the world, as boxes: nothing is stored per chunk. Each chunk has a unique number,
/// its place, which indexes arrays of per-chunk state.
class AreaOfInterest {
 public:
  using Place = std::uint32_t;

  AreaOfInterest() = default;  // no chunks
  /// The View has at most 2^23 chunks.
  explicit AreaOfInterest(const View& view);

  /// The box of each level, cut off at the world's edge.
  [[nodiscard]] std::vector<LevelBox> boxes() const;
  /// Exclusive upper bound of all places; at most twice the number of chunks.
  [[nodiscard]] std::size_t places() const { return places_; }
  [[nodiscard]] std::optional<Place> place_of(ChunkKey key) const;

  /// The rows that the View wants on the level of `key`.
  [[nodiscard]] ChunkRange rows_of(ChunkKey key) const { return level_of(key.lod)->box.y; }

  /// Unique priority of a chunk, lower for chunks wanted sooner: ViewOrder's rank, and the place.
  [[nodiscard]] std::uint64_t rank(ChunkKey key, Place place) const;
  /// Orders by distance only, at a tenth of the cost; rings follow one another as in rank().
  [[nodiscard]] std::uint64_t coarse_priority(ChunkKey key, Place place) const;
  /// Greater than every coarse priority of the same ring, and not greater than any beyond it.
  [[nodiscard]] static std::uint64_t end_of_ring(std::uint64_t coarse_priority);
  /// Returns true if the centre of `chunk` is at most `base_chunks` base chunks farther away than
  /// `nearest`'s.
  [[nodiscard]] bool within(ChunkKey chunk, ChunkKey nearest, int base_chunks) const;
  /// Returns true if the chunk is in the two nearest rings: the 27 chunks of level 0 around the centre.
  [[nodiscard]] bool is_near(ChunkKey key) const;
  /// Calls visit(Place) for the near chunks of the area.
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
  /// The place encoded in a rank or coarse priority.
  [[nodiscard]] static Place place_of_rank(std::uint64_t rank);
  /// The chunk and the place encoded in a rank or coarse priority.
  [[nodiscard]] std::pair<ChunkKey, Place> ranked(std::uint64_t rank) const;

  /// Position of next_column().
  struct ColumnCursor {
    std::size_t level = 0;
    std::int64_t ring = 0;  // distance from the centre's column, along x or z
    std::int64_t step = 0;  // along the ring
  };
  /// Returns the lowest chunk of the next column that has chunks; nullopt after the last. Level by level,
  /// each level outward in squares.
  [[nodiscard]] std::optional<ChunkKey> next_column(ColumnCursor& cursor) const;

  /// Calls visit(ChunkKey, Place) for every chunk, in unspecified order.
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

  /// Calls visit(place, place in other, count) for every run of chunks that are also in `other` and in all of
  /// `between`.
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
    Place first;  // the lowest corner of the outer box

    /// The chunk above has the next place.
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

  std::vector<Level> levels_;
  Place places_ = 0;
  glm::i64vec3 centre_{};
  ViewOrder order_;
};

}  // namespace talus::server
