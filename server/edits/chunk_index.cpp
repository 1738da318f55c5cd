#include "edits/chunk_index.h"

#include <algorithm>
#include <functional>
#include <mutex>

namespace talus::server {
namespace {

std::size_t shard_of_column(ChunkKey column, std::size_t shards) {
  // The map in the shard uses the low bits of the same hash.
  return (std::hash<ChunkKey>{}(column) >> 48) % shards;
}

}  // namespace

std::size_t ChunkIndex::region_of(ChunkKey key) {
  const ChunkKey region{{key.coord.x >> 5, 0, key.coord.z >> 5}, key.lod};
  return (std::hash<ChunkKey>{}(region) >> 16) % kRegionBits;
}

bool ChunkIndex::is_touched(ChunkKey key) const {
  const std::size_t region = region_of(key);
  return (regions_[region / 64].load(std::memory_order_acquire) >> (region % 64) & 1) != 0;
}

std::uint64_t ChunkIndex::revision(ChunkKey key) const {
  if (!is_touched(key)) return 0;
  const ChunkKey column = column_of(key);
  const Shard& shard = shards_[shard_of_column(column, kShards)];
  const std::shared_lock lock{shard.mutex};
  const auto found = shard.columns.find(column);
  if (found == shard.columns.end()) return 0;
  const auto at = std::ranges::lower_bound(found->second, key.coord.y, {}, &Chunk::row);
  return at == found->second.end() || at->row != key.coord.y ? 0 : at->revision;
}

ChunkRange ChunkIndex::rows(ChunkKey key) const {
  if (!is_touched(key)) return {};
  const ChunkKey column = column_of(key);
  const Shard& shard = shards_[shard_of_column(column, kShards)];
  const std::shared_lock lock{shard.mutex};
  const auto found = shard.columns.find(column);
  if (found == shard.columns.end()) return {};
  return {found->second.front().row, found->second.back().row};
}

std::uint64_t ChunkIndex::raise(ChunkKey key, std::uint64_t revision) {
  const ChunkKey column = column_of(key);
  Shard& shard = shards_[shard_of_column(column, kShards)];
  const std::lock_guard lock{shard.mutex};
  const auto [found, new_column] = shard.columns.try_emplace(column);
  Column& chunks = found->second;
  auto at = std::ranges::lower_bound(chunks, key.coord.y, {}, &Chunk::row);
  if (at == chunks.end() || at->row != key.coord.y) {
    at = chunks.insert(at, {key.coord.y, 0});
    chunks_.fetch_add(1, std::memory_order_relaxed);
    bytes_.fetch_add(kChunkBytes + (new_column ? kColumnBytes : 0), std::memory_order_relaxed);
    const std::size_t region = region_of(key);
    regions_[region / 64].fetch_or(std::uint64_t{1} << (region % 64), std::memory_order_release);
  }
  const std::uint64_t before = at->revision;
  at->revision = std::max(before, revision);
  return before;
}

}  // namespace talus::server
