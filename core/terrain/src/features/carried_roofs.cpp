#include "features/carried_roofs.h"

#include <algorithm>

namespace talus::terrain {

void CarriedRoofs::start(int width, int depth) {
  width_ = width;
  depth_ = depth;
  for (ColumnBits* const bits : {&roofed_, &open_, &touches_east_, &touches_south_, &solid_, &carried_,
                                 &links_.west, &links_.east, &links_.north, &links_.south}) {
    bits->start(width, depth);
  }
}

void CarriedRoofs::find(int first_z, int last_z, int span) {
  for (int z = 0; z < depth_; ++z) link(z);
  for (int z = first_z; z < last_z; ++z) {
    for (int word = 0; word * 64 < width_; ++word) {
      const auto i = static_cast<std::size_t>(word);
      if (roofed_.row(z)[i] == 0) continue;
      carried_.row(z)[i] = carried_along_row(z, word, span) | carried_across_rows(z, word, span);
    }
  }
}

void CarriedRoofs::link(int z) {
  const std::uint64_t* const roofed = roofed_.row(z);
  for (int word = 0; word * 64 < width_; ++word) {
    const auto i = static_cast<std::size_t>(word);
    const std::uint64_t columns = bits_below(width_ - 64 * word);
    solid_.row(z)[i] = columns & ~(roofed[i] | open_.row(z)[i]);
    if (roofed[i] == 0) continue;
    links_.west.row(z)[i] = roofed[i] & touches_east_.from(z, 64 * word - 1);
    links_.east.row(z)[i] = roofed[i] & touches_east_.row(z)[i];
    links_.north.row(z)[i] = z > 0 ? roofed[i] & touches_south_.row(z - 1)[i] : 0;
    links_.south.row(z)[i] = roofed[i] & touches_south_.row(z)[i];
  }
}

// Extends lines of links column by column. Every part of such a line is such a line too, so carried roofs are
// carried only by carried roofs.
std::uint64_t CarriedRoofs::carried_along_row(int z, int word, int span) const {
  const auto i = static_cast<std::size_t>(word);
  std::uint64_t carried = 0;
  for (const int step : {-1, 1}) {
    const ColumnBits& links = step < 0 ? links_.west : links_.east;
    std::uint64_t line = links.row(z)[i];
    for (int far = 1; far <= span && line != 0; ++far) {
      const int first = 64 * word + step * far;
      carried |= line & solid_.from(z, first);
      line &= links.from(z, first);
    }
  }
  return carried;
}

std::uint64_t CarriedRoofs::carried_across_rows(int z, int word, int span) const {
  const auto i = static_cast<std::size_t>(word);
  std::uint64_t carried = 0;
  for (const int step : {-1, 1}) {
    const ColumnBits& links = step < 0 ? links_.north : links_.south;
    std::uint64_t line = links.row(z)[i];
    for (int far = 1; far <= span && line != 0; ++far) {
      const int row = z + step * far;
      if (row < 0 || row >= depth_) break;
      carried |= line & solid_.row(row)[i];
      line &= links.row(row)[i];
    }
  }
  return carried;
}

}  // namespace talus::terrain
