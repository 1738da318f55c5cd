// The world as a map of square tiles, as web maps have it. Pure.
#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

namespace talus::map {

inline constexpr int kTilePixels = 256;  // a side
inline constexpr int kMaxZoom = 12;      // a base column a pixel; at each zoom below it twice as many a side

/// Pixel (0, 0) of tile (x, z) is base column (256 x, 256 z) << (12 - zoom); x goes east and z south.
struct Tile {
  int zoom = 0;
  std::int64_t x = 0;
  std::int64_t z = 0;
  bool operator==(const Tile&) const = default;

  [[nodiscard]] std::int64_t columns_a_pixel() const { return std::int64_t{1} << (kMaxZoom - zoom); }
};

/// A tile of the world, or one line that says what is wrong.
[[nodiscard]] tl::expected<Tile, std::string> checked_tile(std::int64_t zoom, std::int64_t x, std::int64_t z);

}  // namespace talus::map
