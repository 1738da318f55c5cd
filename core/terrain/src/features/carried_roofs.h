// Decides which roofs of caves hold (docs/DESIGN.md, "Caves"). Private to core/terrain.
#pragma once

#include <cstdint>

#include "features/column_bits.h"

namespace talus::terrain {

/// A rectangle of columns, each solid, roofed or open. Reuses its memory; not thread-safe.
class CarriedRoofs {
 public:
  /// Resets: all columns are solid and no two touch.
  void start(int width, int depth);

  [[nodiscard]] ColumnBits& roofed() { return roofed_; }
  [[nodiscard]] const ColumnBits& roofed() const { return roofed_; }
  [[nodiscard]] ColumnBits& open() { return open_; }
  [[nodiscard]] const ColumnBits& open() const { return open_; }
  /// Columns that touch the next column in their row, and the column in the next row. The bit has no meaning
  /// if neither column is roofed.
  [[nodiscard]] ColumnBits& touches_east() { return touches_east_; }
  [[nodiscard]] ColumnBits& touches_south() { return touches_south_; }

  /// Finds the carried roofs in rows first_z <= z < last_z, after all of the above is set. A roof is carried
  /// if a straight line of at most `span` roofed columns, each touching the next, ends at a solid column that
  /// the last one touches.
  void find(int first_z, int last_z, int span);
  [[nodiscard]] const ColumnBits& carried() const { return carried_; }

 private:
  /// By direction: columns that are roofed and touch the next one.
  struct Links {
    ColumnBits west, east, north, south;
  };

  void link(int z);
  [[nodiscard]] std::uint64_t carried_along_row(int z, int word, int span) const;
  [[nodiscard]] std::uint64_t carried_across_rows(int z, int word, int span) const;

  int width_ = 0;
  int depth_ = 0;
  ColumnBits roofed_;
  ColumnBits open_;
  ColumnBits touches_east_;
  ColumnBits touches_south_;
  ColumnBits solid_;
  ColumnBits carried_;
  Links links_;
};

}  // namespace talus::terrain
