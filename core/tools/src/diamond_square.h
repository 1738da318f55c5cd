// A fractal height map by midpoint displacement (Fournier, Fussell and Carpenter, 1982), to compare with
// noise and as an input that repeats.
#pragma once

#include <cstdint>

#include <talus/terrain/height_map.h>

namespace talus::tools {

inline constexpr int kMinDiamondSide = 8;
inline constexpr int kMaxDiamondSide = 8192;

struct DiamondSquareOptions {
  std::uint64_t seed = 1;
  int side = 512;          // samples: a power of two, kMinDiamondSide to kMaxDiamondSide
  double roughness = 0.5;  // 0 to 1: the displacement of a grid over that of the grid twice as wide
};

/// Samples of 16 bits from 0 to 65535, both of which occur. The last row and column are the neighbours of the
/// first, so that the map repeats without a seam. Integers throughout, and randomness by position: the same
/// on every machine.
[[nodiscard]] terrain::HeightMap diamond_square(const DiamondSquareOptions& options);

}  // namespace talus::tools
