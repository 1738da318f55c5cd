// Pieces of water on a map.
#pragma once

#include <cstdint>
#include <span>

namespace talus::tools {

/// A lone piece has fewer columns and does not touch the map's edge, beyond which it might continue.
inline constexpr std::int64_t kLonePiece = 16;

struct WaterPieces {
  std::int64_t water = 0;   // columns
  std::int64_t lone = 0;    // columns of lone pieces
  std::int64_t inland = 0;  // columns of all pieces that touch no edge: lakes and ponds
};

/// Columns connect over edges and corners. `wet` is 1 for water; width x depth columns.
[[nodiscard]] WaterPieces water_pieces(std::span<const std::uint8_t> wet, int width, int depth);

}  // namespace talus::tools
