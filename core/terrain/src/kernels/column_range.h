#pragma once

#include <cstddef>

namespace talus::terrain {

/// Columns of a row, from the first to before the last; none where that is the first.
struct ColumnRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

}  // namespace talus::terrain
