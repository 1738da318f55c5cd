// A fractal height map by midpoint displacement (Fournier, Fussell and Carpenter, 1982), for comparison with
// noise and as a periodic input.
#pragma once

#include <cstdint>

#include <talus/terrain/height_map.h>

namespace talus::tools {

inline constexpr int kMinDiamondSide = 8;
inline constexpr int kMaxDiamondSide = 8192;

struct DiamondSquareOptions {
  std::uint64_t seed = 1;
  int side = 512;          // samples: a power of two, kMinDiamondSide to kMaxDiamondSide
  double roughness = 0.5;  // 0 to 1: a grid's displacement over that of twice its spacing
};

/// Returns 16-bit samples from 0 to 65535, both of which occur. The map is periodic: the last row and column
/// adjoin the first. Integer arithmetic and position-based randomness give the same result on every machine.
[[nodiscard]] terrain::HeightMap diamond_square(const DiamondSquareOptions& options);

}  // namespace talus::tools
