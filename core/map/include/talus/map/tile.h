// The world as a map of square tiles, like those of web maps.
#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

namespace talus::map {

inline constexpr int kTilePixels = 256;  // per side
inline constexpr int kMaxZoom = 12;      // 1 base column per pixel, 2 at zoom 11, 4 at zoom 10, ...

/// Pixel (0, 0) of tile (x, z) is base column (256 x, 256 z) << (12 - zoom); x goes east and z south.
struct Tile {
  int zoom = 0;
  std::int64_t x = 0;
  std::int64_t z = 0;
  bool operator==(const Tile&) const = default;

  [[nodiscard]] std::int64_t columns_a_pixel() const { return std::int64_t{1} << (kMaxZoom - zoom); }
};

/// Returns the tile, or a one-line error if it lies outside the world.
[[nodiscard]] tl::expected<Tile, std::string> checked_tile(std::int64_t zoom, std::int64_t x, std::int64_t z);

}  // namespace talus::map
