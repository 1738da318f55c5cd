// Which chunks a View wants, and how much. No I/O.
//
// Level 0 is a box: every chunk at most horizontal_radius away along x and z and vertical_radius along y.
// A ring of level l takes every chunk of that level that touches the columns at most `radius` base chunks
// away and the rows of the box, but for those whose columns the finer levels cover whole: the coarse
// chunks close the gap to the finer ones, and may overlap them at the edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/voxel/coords.h>

#include "view/shell.h"

namespace talus::server {

struct ViewRing {
  Lod lod;
  int radius = 0;  // base chunks
  bool operator==(const ViewRing&) const = default;
};

struct View {
  glm::i64vec3 centre{};  // the base chunk around which the player is; anywhere, in the world or not
  glm::vec3 direction{};  // zero, or anything that is not finite: no preference
  int horizontal_radius = 0;
  int vertical_radius = 0;
  std::vector<ViewRing> rings;  // levels and radii growing
};

/// Whether both have the same chunks, whatever their order.
[[nodiscard]] bool same_chunks(const View& a, const View& b);

/// How many chunks the view has where the world's edge cuts none off. Costs nothing.
[[nodiscard]] std::uint64_t count_chunks(const View& view);

/// A View's chunks inside the world, as boxes: nothing is kept for a single chunk. Each has a place, a
/// number that is its own, so that what is known of it fits into an array.
class Interest {
 public:
  using Place = std::uint32_t;

  Interest() = default;  // wants nothing
  /// The View has at most 2^23 chunks.
  explicit Interest(const View& view);

  /// More than any place; at most a third more than there are chunks.
  [[nodiscard]] std::size_t places() const { return places_; }
  [[nodiscard]] std::optional<Place> place_of(ChunkKey key) const;

  /// The rows of the level of `key`, which the View wants.
  [[nodiscard]] Span rows_of(ChunkKey key) const { return level_of(key.lod)->shell.y; }

  /// Less for what is wanted sooner, and each chunk's own: by the distance of the centres in whole base
  /// chunks, the ring; then by the angle to the view direction; then by the exact distance.
  [[nodiscard]] std::uint64_t rank(ChunkKey key, Place place) const;
  /// Orders by distance alone, but costs a tenth; rings come one after the other, as in rank().
  [[nodiscard]] std::uint64_t rough_rank(ChunkKey key, Place place) const;
  /// More than every rough rank of the ring in which `rough_rank` is, and no more than those beyond it.
  [[nodiscard]] static std::uint64_t end_of_ring(std::uint64_t rough_rank);
  /// The chunk whose rank or rough rank it is, and its place.
  [[nodiscard]] std::pair<ChunkKey, Place> ranked(std::uint64_t rank) const;

  /// Calls visit(ChunkKey, Place) for every chunk, in no order that matters.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for (const Level& level : levels_) {
      const Span ys = level.shell.y;
      level.shell.for_each_column([&](std::int64_t x, std::int64_t z) {
        for (std::int64_t y = ys.first; y <= ys.last; ++y) {
          visit(ChunkKey{{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                          static_cast<std::int32_t>(z)},
                         level.shell.lod},
                level.place_of(x, y, z));
        }
      });
    }
  }

  /// Calls visit(place, place in other, count) for every run of chunks that `other` and all of `between` want
  /// as well.
  template <typename Visit>
  void for_each_shared(const Interest& other, std::span<const Interest> between, Visit&& visit) const {
    for (const Level& mine : levels_) {
      const Level* const theirs = other.level_of(mine.shell.lod);
      if (theirs == nullptr) continue;
      Span ys = overlap(mine.shell.y, theirs->shell.y);
      for (const Interest& each : between) {
        const Level* const level = each.level_of(mine.shell.lod);
        ys = level == nullptr ? Span{} : overlap(ys, level->shell.y);
      }
      if (ys.size() == 0) continue;
      mine.shell.for_each_column([&](std::int64_t x, std::int64_t z) {
        if (!theirs->shell.has_column(x, z)) return;
        for (const Interest& each : between) {
          if (!each.level_of(mine.shell.lod)->shell.has_column(x, z)) return;
        }
        visit(mine.place_of(x, ys.first, z), theirs->place_of(x, ys.first, z), ys.size());
      });
    }
  }

 private:
  struct Level {
    Shell shell;
    Place first;  // the place of index 0

    [[nodiscard]] Place place_of(std::int64_t x, std::int64_t y, std::int64_t z) const {
      return static_cast<Place>(first + shell.index_of(x, y, z));
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
