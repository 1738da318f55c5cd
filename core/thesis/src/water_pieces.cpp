#include "water_pieces.h"

#include <cstddef>
#include <vector>

namespace talus::tools {

WaterPieces water_pieces(std::span<const std::uint8_t> wet, int width, int depth) {
  WaterPieces pieces;
  std::vector<std::uint8_t> open{wet.begin(), wet.end()};  // water not yet in a piece
  std::vector<std::size_t> next;
  const auto columns_across = static_cast<std::size_t>(width);
  for (std::size_t first = 0; first < open.size(); ++first) {
    if (open[first] == 0) continue;
    open[first] = 0;
    next.assign(1, first);
    std::int64_t columns = 0;
    bool at_edge = false;
    while (!next.empty()) {
      const std::size_t column = next.back();
      next.pop_back();
      ++columns;
      const int x = static_cast<int>(column % columns_across);
      const int z = static_cast<int>(column / columns_across);
      at_edge = at_edge || x == 0 || z == 0 || x == width - 1 || z == depth - 1;
      for (int to_z = z > 0 ? z - 1 : z; to_z <= z + 1 && to_z < depth; ++to_z) {
        for (int to_x = x > 0 ? x - 1 : x; to_x <= x + 1 && to_x < width; ++to_x) {
          const auto to = static_cast<std::size_t>(to_z) * columns_across + static_cast<std::size_t>(to_x);
          if (open[to] == 0) continue;
          open[to] = 0;
          next.push_back(to);
        }
      }
    }
    pieces.water += columns;
    if (at_edge) continue;
    pieces.inland += columns;
    if (columns < kLonePiece) pieces.lone += columns;
  }
  return pieces;
}

}  // namespace talus::tools
