// Which roofs of caves hold (docs/DESIGN.md, "Caves"). Private to core/terrain.
#pragma once

#include <cstdint>

#include "features/column_bits.h"

namespace talus::terrain {

/// Of a rectangle of columns, each solid, roofed or open. Keeps its memory. For one thread at a time.
class CarriedRoofs {
 public:
  /// All columns are solid and no two touch.
  void start(int width, int depth);

  [[nodiscard]] ColumnBits& roofed() { return roofed_; }
  [[nodiscard]] const ColumnBits& roofed() const { return roofed_; }
  [[nodiscard]] ColumnBits& open() { return open_; }
  [[nodiscard]] const ColumnBits& open() const { return open_; }
  /// Columns that touch the next one in their row, and in the next row. Of columns neither of which is roofed
  /// the bits have no meaning.
  [[nodiscard]] ColumnBits& touches_east() { return touches_east_; }
  [[nodiscard]] ColumnBits& touches_south() { return touches_south_; }

  /// In rows first_z <= z < last_z, once all of the above is set: a roof is carried where a straight line of
  /// at most `span` roofed columns, each touching the next, ends beside a solid one that the last touches.
  void find(int first_z, int last_z, int span);
  [[nodiscard]] const ColumnBits& carried() const { return carried_; }

 private:
  /// In each of four directions: columns that are roofed and touch the next one.
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
