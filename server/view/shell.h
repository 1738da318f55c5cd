// The chunks of one level in a View: a box without the columns of a smaller one. Pure values.
#pragma once

#include <algorithm>
#include <cstdint>

#include <talus/voxel/coords.h>

namespace talus::server {

/// Coordinates `first` to `last` along one axis; empty where last < first.
struct Span {
  std::int64_t first = 0;
  std::int64_t last = -1;

  [[nodiscard]] std::uint64_t size() const {
    return last < first ? 0 : static_cast<std::uint64_t>(last - first) + 1;
  }
  [[nodiscard]] bool contains(std::int64_t at) const { return first <= at && at <= last; }
};

[[nodiscard]] inline Span overlap(Span a, Span b) {
  return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

struct Shell {
  Lod lod;
  Span x, y, z;
  Span hole_x, hole_z;

  [[nodiscard]] std::uint64_t box_size() const { return x.size() * y.size() * z.size(); }
  [[nodiscard]] bool has_column(std::int64_t at_x, std::int64_t at_z) const {
    return x.contains(at_x) && z.contains(at_z) && !(hole_x.contains(at_x) && hole_z.contains(at_z));
  }

  /// The chunk's number in the box, one more for the chunk above it.
  [[nodiscard]] std::uint64_t index_of(std::int64_t at_x, std::int64_t at_y, std::int64_t at_z) const {
    const auto from = [](Span span, std::int64_t at) { return static_cast<std::uint64_t>(at - span.first); };
    return (from(z, at_z) * x.size() + from(x, at_x)) * y.size() + from(y, at_y);
  }
  [[nodiscard]] ChunkCoord coord_of(std::uint64_t index) const {
    const auto at = [](Span span, std::uint64_t offset) {
      return static_cast<std::int32_t>(span.first + static_cast<std::int64_t>(offset));
    };
    const std::uint64_t column = index / y.size();
    return {at(x, column % x.size()), at(y, index % y.size()), at(z, column / x.size())};
  }

  /// Calls visit(x, z) for every column.
  template <typename Visit>
  void for_each_column(Visit&& visit) const {
    for (std::int64_t at_z = z.first; at_z <= z.last; ++at_z) {
      for (std::int64_t at_x = x.first; at_x <= x.last; ++at_x) {
        if (has_column(at_x, at_z)) visit(at_x, at_z);
      }
    }
  }
};

}  // namespace talus::server
