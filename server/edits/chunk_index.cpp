#include "edits/chunk_index.h"

#include <algorithm>
#include <functional>
#include <mutex>

namespace talus::server {
namespace {

std::size_t shard_of(ChunkKey key, std::size_t shards) {
  // The map in the shard uses the low bits of the same hash.
  return (std::hash<ChunkKey>{}(key) >> 48) % shards;
}

/// The first column of the key's region.
ChunkKey region_of(ChunkKey key) {
  return {{key.coord.x & -kRegionColumns, 0, key.coord.z & -kRegionColumns}, key.lod};
}

std::uint16_t place_of(ChunkKey key) {
  const std::int32_t x = key.coord.x & (kRegionColumns - 1);
  const std::int32_t z = key.coord.z & (kRegionColumns - 1);
  return static_cast<std::uint16_t>(z * kRegionColumns + x);
}

}  // namespace

std::size_t ChunkIndex::region_bit(ChunkKey key) {
  return (std::hash<ChunkKey>{}(region_of(key)) >> 16) % kRegionBits;
}

bool ChunkIndex::is_touched(ChunkKey key) const {
  const std::size_t region = region_bit(key);
  return (regions_[region / 64].load(std::memory_order_acquire) >> (region % 64) & 1) != 0;
}

std::uint64_t ChunkIndex::revision(ChunkKey key) const {
  if (!is_touched(key)) return 0;
  const ChunkKey column = column_of(key);
  const Shard& shard = shards_[shard_of(column, kShards)];
  const std::shared_lock lock{shard.mutex};
  const auto* const found = shard.columns.find(column);
  if (found == nullptr) return 0;
  const auto at = std::ranges::lower_bound(*found, key.coord.y, {}, &Chunk::row);
  return at == found->end() || at->row != key.coord.y ? 0 : at->revision;
}

ChunkRange ChunkIndex::rows(ChunkKey key) const {
  if (!is_touched(key)) return {};
  const ChunkKey column = column_of(key);
  const Shard& shard = shards_[shard_of(column, kShards)];
  const std::shared_lock lock{shard.mutex};
  const auto* const found = shard.columns.find(column);
  if (found == nullptr) return {};
  return {found->front().row, found->back().row};
}

std::uint64_t ChunkIndex::column_revision(ChunkKey key) const {
  if (!is_touched(key)) return 0;
  const ChunkKey region = region_of(key);
  const Regions& regions = columns_by_region_[shard_of(region, kShards)];
  const std::shared_lock lock{regions.mutex};
  const auto* const found = regions.columns.find(region);
  if (found == nullptr) return 0;
  const std::uint16_t place = place_of(key);
  const auto at = std::ranges::lower_bound(*found, place, {}, &EditedColumn::place);
  return at == found->end() || at->place != place ? 0 : at->revision;
}

std::vector<EditedColumn> ChunkIndex::edited_columns(ChunkKey key) const {
  if (!is_touched(key)) return {};
  const ChunkKey region = region_of(key);
  const Regions& regions = columns_by_region_[shard_of(region, kShards)];
  const std::shared_lock lock{regions.mutex};
  const auto* const found = regions.columns.find(region);
  return found == nullptr ? std::vector<EditedColumn>{} : *found;
}

void ChunkIndex::raise_column(ChunkKey key, std::uint64_t revision) {
  const ChunkKey region = region_of(key);
  Regions& regions = columns_by_region_[shard_of(region, kShards)];
  const std::lock_guard lock{regions.mutex};
  const auto [columns, new_region] = regions.columns.emplace(region);
  if (new_region) bytes_.fetch_add(kRegionBytes, std::memory_order_relaxed);
  const std::uint16_t place = place_of(key);
  auto at = std::ranges::lower_bound(columns, place, {}, &EditedColumn::place);
  if (at == columns.end() || at->place != place) at = columns.insert(at, {place, 0});
  at->revision = std::max(at->revision, revision);
}

std::uint64_t ChunkIndex::raise(ChunkKey key, std::uint64_t revision) {
  const ChunkKey column = column_of(key);
  Shard& shard = shards_[shard_of(column, kShards)];
  const std::lock_guard lock{shard.mutex};
  const auto [chunks, new_column] = shard.columns.emplace(column);
  auto at = std::ranges::lower_bound(chunks, key.coord.y, {}, &Chunk::row);
  if (at == chunks.end() || at->row != key.coord.y) {
    at = chunks.insert(at, {key.coord.y, 0});
    chunks_.fetch_add(1, std::memory_order_relaxed);
    bytes_.fetch_add(kChunkBytes + (new_column ? kColumnBytes : 0), std::memory_order_relaxed);
    const std::size_t region = region_bit(key);
    regions_[region / 64].fetch_or(std::uint64_t{1} << (region % 64), std::memory_order_release);
  }
  const std::uint64_t before = at->revision;
  at->revision = std::max(before, revision);
  return before;
}

}  // namespace talus::server
