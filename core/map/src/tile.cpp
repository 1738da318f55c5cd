#include <talus/map/tile.h>

namespace talus::map {

namespace {

constexpr std::int64_t kWorldEdge = std::int64_t{1} << 36;  // base columns

}  // namespace

tl::expected<Tile, std::string> checked_tile(std::int64_t zoom, std::int64_t x, std::int64_t z) {
  if (zoom < 0 || zoom > kMaxZoom) {
    return tl::make_unexpected("zoom " + std::to_string(zoom) + " is not in 0 to " +
                               std::to_string(kMaxZoom));
  }
  const Tile tile{static_cast<int>(zoom), x, z};
  const std::int64_t limit = kWorldEdge / (kTilePixels * tile.columns_a_pixel());
  if (x < -limit || x >= limit || z < -limit || z >= limit) {
    return tl::make_unexpected("tile (" + std::to_string(x) + ", " + std::to_string(z) +
                               ") lies outside of the world; at zoom " + std::to_string(zoom) + " it has " +
                               std::to_string(-limit) + " to " + std::to_string(limit - 1));
  }
  return tile;
}

}  // namespace talus::map
