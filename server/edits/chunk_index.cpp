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

ChunkIndex::ChunkEntry ChunkIndex::find(ChunkKey key) const {
  if (!is_touched(key)) return {};
  const ChunkKey column = column_of(key);
  const Shard& shard = shards_[shard_of(column, kShards)];
  const std::shared_lock lock{shard.mutex};
  const auto* const found = shard.columns.find(column);
  if (found == nullptr) return {};
  const auto at = std::ranges::lower_bound(found->chunks, key.coord.y, {}, &Chunk::row);
  if (at == found->chunks.end() || at->row != key.coord.y) return {};
  return {at->revision, at->change};
}

ChunkRange ChunkIndex::rows(ChunkKey key) const {
  if (!is_touched(key)) return {};
  const ChunkKey column = column_of(key);
  const Shard& shard = shards_[shard_of(column, kShards)];
  const std::shared_lock lock{shard.mutex};
  const auto* const found = shard.columns.find(column);
  if (found == nullptr) return {};
  return {found->chunks.front().row, found->chunks.back().row};
}

std::uint64_t ChunkIndex::column_revision(ChunkKey key) const {
  if (!is_touched(key)) return 0;
  const ChunkKey column = column_of(key);
  const Shard& shard = shards_[shard_of(column, kShards)];
  const std::shared_lock lock{shard.mutex};
  const auto* const found = shard.columns.find(column);
  return found == nullptr ? 0 : found->revision;
}

std::vector<EditedColumn> ChunkIndex::edited_columns(ChunkKey key) const {
  if (!is_touched(key)) return {};
  const ChunkKey region = region_of(key);
  const Places places = places_of(region);
  std::vector<EditedColumn> columns;
  columns.reserve(places.count());
  for (std::uint16_t place = 0; place < places.size(); ++place) {
    if (!places[place]) continue;
    const std::int32_t x = region.coord.x + place % kRegionColumns;
    const std::int32_t z = region.coord.z + place / kRegionColumns;
    columns.push_back({place, column_revision({{x, 0, z}, region.lod})});
  }
  return columns;
}

ChunkIndex::Places ChunkIndex::places_of(ChunkKey region) const {
  const Regions& regions = columns_of_regions_[shard_of(region, kShards)];
  const std::shared_lock lock{regions.mutex};
  const Places* const found = regions.places.find(region);
  return found == nullptr ? Places{} : *found;
}

void ChunkIndex::edited_chunks(const LevelBox& box, const ColumnFilter& wanted,
                               std::vector<ChunkKey>& found) const {
  const auto add_column = [&](ChunkKey column) {
    const Shard& shard = shards_[shard_of(column, kShards)];
    const std::shared_lock lock{shard.mutex};
    const Column* const held = shard.columns.find(column);
    if (held == nullptr) return;
    auto chunk = std::ranges::lower_bound(held->chunks, box.y.first, {}, &Chunk::row);
    for (; chunk != held->chunks.end() && chunk->row <= box.y.last; ++chunk) {
      found.push_back({{column.coord.x, chunk->row, column.coord.z}, column.lod});
    }
  };
  constexpr std::int64_t kEdge = kRegionColumns;
  for (std::int64_t z = floor_div(box.z.first, kEdge); z <= floor_div(box.z.last, kEdge); ++z) {
    for (std::int64_t x = floor_div(box.x.first, kEdge); x <= floor_div(box.x.last, kEdge); ++x) {
      const ChunkKey region{{static_cast<std::int32_t>(x * kEdge), 0, static_cast<std::int32_t>(z * kEdge)},
                            box.lod};
      if (!is_touched(region)) continue;
      const Places places = places_of(region);
      for (std::size_t place = places._Find_first(); place < places.size();
           place = places._Find_next(place)) {
        ChunkKey column = region;
        column.coord.x += static_cast<std::int32_t>(place) % kRegionColumns;
        column.coord.z += static_cast<std::int32_t>(place) / kRegionColumns;
        if (box.has_column(column.coord.x, column.coord.z) && wanted(column)) add_column(column);
      }
    }
  }
}

void ChunkIndex::raise_column(ChunkKey key, std::uint64_t revision) {
  const ChunkKey column = column_of(key);
  {
    Shard& shard = shards_[shard_of(column, kShards)];
    const std::lock_guard lock{shard.mutex};
    std::uint64_t& held = shard.columns[column].revision;
    const bool is_new = held == 0;
    held = std::max(held, revision);
    if (!is_new) return;
  }
  const ChunkKey region = region_of(key);
  Regions& regions = columns_of_regions_[shard_of(region, kShards)];
  const std::lock_guard lock{regions.mutex};
  const auto [places, new_region] = regions.places.emplace(region);
  if (new_region) bytes_.fetch_add(kRegionBytes, std::memory_order_relaxed);
  places.set(place_of(key));
}

std::uint64_t ChunkIndex::raise(ChunkKey key, ChunkEntry edited) {
  const ChunkKey column = column_of(key);
  Shard& shard = shards_[shard_of(column, kShards)];
  const std::lock_guard lock{shard.mutex};
  const auto [held, new_column] = shard.columns.emplace(column);
  std::vector<Chunk>& chunks = held.chunks;
  auto at = std::ranges::lower_bound(chunks, key.coord.y, {}, &Chunk::row);
  if (at == chunks.end() || at->row != key.coord.y) {
    at = chunks.insert(at, {.row = key.coord.y});
    chunks_.fetch_add(1, std::memory_order_relaxed);
    bytes_.fetch_add(kChunkBytes + (new_column ? kColumnBytes : 0), std::memory_order_relaxed);
    const std::size_t region = region_bit(key);
    regions_[region / 64].fetch_or(std::uint64_t{1} << (region % 64), std::memory_order_release);
  }
  const std::uint64_t before = at->revision;
  if (edited.revision > before) {
    at->revision = edited.revision;
    at->change = edited.change;
  }
  return before;
}

}  // namespace talus::server
