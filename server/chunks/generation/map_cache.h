// Tiles of the map in memory, as PNG files, bounded in bytes. Callable from any thread; a call locks one
// shard.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

#include <talus/map/tile.h>

#include "chunks/cache/sharded_cache.h"
#include "chunks/heights_query.h"

template <>
struct std::hash<talus::map::Tile> {
  [[nodiscard]] std::size_t operator()(const talus::map::Tile& tile) const {
    // Odd multipliers, and the high bits folded down: shards go by bits in the middle, tables by the low
    // ones.
    std::uint64_t mixed = static_cast<std::uint64_t>(tile.zoom) * 0x9E37'79B9'7F4A'7C15U;
    mixed = (mixed ^ static_cast<std::uint64_t>(tile.x)) * 0xBF58'476D'1CE4'E5B9U;
    mixed = (mixed ^ (mixed >> 31U) ^ static_cast<std::uint64_t>(tile.z)) * 0x94D0'49BB'1331'11EBU;
    return mixed ^ (mixed >> 29U);
  }
};

namespace talus::server {

class MapCache {
 public:
  explicit MapCache(std::size_t capacity_bytes) : tiles_{capacity_bytes} {}

  /// Returns null if the tile is not cached.
  [[nodiscard]] PicturePtr find(const map::Tile& tile) { return tiles_.find(tile).value_or(nullptr); }
  void put(const map::Tile& tile, PicturePtr picture) {
    const std::size_t bytes = sizeof(Picture) + picture->png.size();
    tiles_.put(tile, std::move(picture), bytes);
  }

  /// As in ShardedCache.
  void set_capacity(std::size_t capacity_bytes) { tiles_.set_capacity(capacity_bytes); }
  [[nodiscard]] bool fit(std::size_t& probes) { return tiles_.fit(probes); }
  [[nodiscard]] std::size_t bytes() const { return tiles_.bytes(); }

 private:
  ShardedCache<map::Tile, PicturePtr> tiles_;
};

}  // namespace talus::server
