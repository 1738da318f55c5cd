// The contents of a GroundCache. Private to core/terrain.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <list>
#include <memory>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <talus/terrain/ground_cache.h>

namespace talus::terrain {

/// Columns along an edge: few, so that little unused ground is computed.
inline constexpr int kGroundTileSide = 32;
inline constexpr std::size_t kGroundTileColumns = kGroundTileSide * kGroundTileSide;

/// In tiles of a level.
struct GroundTileKey {
  std::int64_t x = 0;
  std::int64_t z = 0;
  int level = 0;
  bool operator==(const GroundTileKey&) const = default;
};

/// The ground of a tile before aprons, z slowest, then x. Immutable once shared.
struct GroundTile {
  template <class Value>
  using Columns = std::array<Value, kGroundTileColumns>;

  /// Most tiles have one value throughout.
  template <class Value>
  struct Values {
    Value all{};
    std::unique_ptr<Columns<Value>> each;  // null: `all` everywhere
  };

  Columns<std::int32_t> heights_fx;
  std::vector<Columns<std::int32_t>> slopes_fx;  // one if the surface computes the level's slopes, else empty
  std::vector<Values<std::uint8_t>> looks;       // by LookRules
  std::vector<Values<std::uint16_t>> shares;     // by ShareRule: before the ramps of slope and cliff

  [[nodiscard]] std::size_t bytes() const;
};
using GroundTilePtr = std::shared_ptr<const GroundTile>;

/// Copies `count` values. Mostly a whole row of a tile, for which the length is a constant.
template <class Value>
void copy_tile_row(const Value* from, int count, Value* to) {
  if (count == kGroundTileSide) {
    std::memcpy(to, from, sizeof(Value) * kGroundTileSide);
  } else {
    std::copy_n(from, count, to);
  }
}

struct GroundTiles {
 public:
  explicit GroundTiles(std::size_t max_bytes, std::unique_ptr<GroundLock> lock = nullptr)
      : max_bytes_{max_bytes}, lock_{std::move(lock)} {}

  /// found[i] is the tile of keys[i], or null.
  void find(std::span<const GroundTileKey> keys, std::span<GroundTilePtr> found);
  void put(const GroundTileKey& key, GroundTilePtr tile);
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Hash {
    std::size_t operator()(const GroundTileKey& key) const;
  };
  class Guard {
   public:
    explicit Guard(GroundLock* lock) : lock_{lock} {
      if (lock_ != nullptr) lock_->lock();
    }
    ~Guard() {
      if (lock_ != nullptr) lock_->unlock();
    }
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

   private:
    GroundLock* const lock_;
  };
  struct Entry {
    GroundTileKey key;
    GroundTilePtr tile;
    std::uint64_t moved = 0;  // `puts_` when it was last moved to the front
  };

  const std::size_t max_bytes_;
  const std::unique_ptr<GroundLock> lock_;
  std::size_t bytes_ = 0;
  std::uint64_t puts_ = 0;
  std::list<Entry> entries_;  // most recently used first; reuse within the first quarter does not move them
  std::unordered_map<GroundTileKey, std::list<Entry>::iterator, Hash> by_key_;
};

}  // namespace talus::terrain
