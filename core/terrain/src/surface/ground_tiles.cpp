#include "surface/ground_tiles.h"

#include <utility>

#include <talus/terrain/lattice_hash.h>

namespace talus::terrain {

std::size_t GroundTile::bytes() const {
  constexpr std::size_t kOverhead = 192;  // its entries in list and table
  std::size_t bytes = sizeof(GroundTile) + kOverhead + slopes_fx.size() * sizeof(Columns<std::int32_t>);
  const auto add = [&](const auto& all) {
    for (const auto& values : all) bytes += sizeof(values) + (values.each ? sizeof(*values.each) : 0);
  };
  add(looks);
  add(shares);
  return bytes;
}

std::size_t GroundTiles::Hash::operator()(const GroundTileKey& key) const {
  const auto level = static_cast<std::uint64_t>(key.level);
  return static_cast<std::size_t>(
      mix64(static_cast<std::uint64_t>(key.x) + mix64(static_cast<std::uint64_t>(key.z) + level)));
}

void GroundTiles::find(std::span<const GroundTileKey> keys, std::span<GroundTilePtr> found) {
  const Guard guard{lock_.get()};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto known = by_key_.find(keys[i]);
    if (known == by_key_.end()) {
      found[i] = nullptr;
      continue;
    }
    Entry& entry = *known->second;
    found[i] = entry.tile;
    // Moving it would touch its neighbours in the list, which are seldom in a near cache.
    if (puts_ - entry.moved <= entries_.size() / 4) continue;
    entry.moved = puts_;
    entries_.splice(entries_.begin(), entries_, known->second);
  }
}

void GroundTiles::put(const GroundTileKey& key, GroundTilePtr tile) {
  const Guard guard{lock_.get()};
  if (by_key_.contains(key)) return;  // another thread was first, with the same tile
  const std::size_t bytes = tile->bytes();
  // Both or neither, whichever allocation fails.
  std::list<Entry> added;
  added.push_front({key, std::move(tile), ++puts_});
  by_key_.emplace(key, added.begin());
  entries_.splice(entries_.begin(), added);
  bytes_ += bytes;
  while (bytes_ > max_bytes_ && !entries_.empty()) {
    bytes_ -= entries_.back().tile->bytes();
    by_key_.erase(entries_.back().key);
    entries_.pop_back();
  }
}

std::size_t GroundTiles::bytes() const {
  const Guard guard{lock_.get()};
  return bytes_;
}

GroundCache::GroundCache(std::size_t max_bytes, std::unique_ptr<GroundLock> lock)
    : tiles_{std::make_unique<GroundTiles>(max_bytes, std::move(lock))} {}
GroundCache::~GroundCache() = default;

std::size_t GroundCache::bytes() const {
  return tiles_->bytes();
}

}  // namespace talus::terrain
