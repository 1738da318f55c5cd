#pragma once

#include <cstddef>

namespace talus::terrain {

/// Columns [first, last) of a row; empty if first == last.
struct ColumnRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

}  // namespace talus::terrain
