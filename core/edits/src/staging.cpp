#include <talus/edits/staging.h>

#include <algorithm>
#include <map>
#include <utility>

namespace talus::edits {
namespace {

/// Overwrites `writes` with `later`, both by ascending index. Few cost one move each, many cost a merge.
void overwrite(std::vector<OverrideWrite>& writes, std::span<const OverrideWrite> later) {
  if (later.size() * 16 < writes.size() || later.size() == 1) {
    for (const OverrideWrite& write : later) {
      const auto at = std::ranges::lower_bound(writes, write.index, {}, &OverrideWrite::index);
      if (at != writes.end() && at->index == write.index) {
        *at = write;
      } else {
        writes.insert(at, write);
      }
    }
    return;
  }
  std::vector<OverrideWrite> merged;
  merged.reserve(writes.size() + later.size());
  auto kept = writes.begin();
  for (const OverrideWrite& write : later) {
    for (; kept != writes.end() && kept->index < write.index; ++kept) merged.push_back(*kept);
    if (kept != writes.end() && kept->index == write.index) ++kept;
    merged.push_back(write);
  }
  merged.insert(merged.end(), kept, writes.end());
  writes = std::move(merged);
}

}  // namespace

std::vector<ChunkWrites> writes_at_all_levels(std::span<const ChunkChanges> changes) {
  std::vector<ChunkWrites> all;
  all.reserve(changes.size());
  // Several base chunks share a coarse chunk, each with voxels anywhere in it.
  std::map<ChunkKey, std::vector<OverrideWrite>> coarse;
  for (const ChunkChanges& each : changes) {
    all.push_back({{each.chunk, Lod{}}, writes_of(each)});
    for (const ChunkWrites& of_level : coarse_writes(each.chunk, all.back().writes)) {
      auto& writes = coarse[of_level.key];
      writes.insert(writes.end(), of_level.writes.begin(), of_level.writes.end());
    }
  }
  for (auto& [key, writes] : coarse) {
    std::ranges::sort(writes, {}, &OverrideWrite::index);
    all.push_back({key, std::move(writes)});
  }
  return all;
}

ChunkOverrides StagedChunk::after() const {
  ChunkOverrides overrides;
  if (before != nullptr) overrides = *before;
  overrides.apply(writes);
  return overrides;
}

const ChunkOverrides* StagingArea::find(ChunkKey chunk) const {
  const auto staged = chunks_.find(chunk);
  return staged == chunks_.end() ? applied_.find(chunk) : staged->second.before;
}

std::span<const OverrideWrite> StagingArea::staged(ChunkKey chunk) const {
  const auto staged = chunks_.find(chunk);
  return staged == chunks_.end() ? std::span<const OverrideWrite>{} : staged->second.writes;
}

void StagingArea::apply(const ChunkWrites& writes) {
  const auto [at, added] = chunks_.try_emplace(writes.key);
  StagedChunk& chunk = at->second;
  if (added) {
    chunk.before = applied_.find(writes.key);
    chunk.writes = writes.writes;
  } else {
    overwrite(chunk.writes, writes.writes);
  }
}

std::vector<ChunkWrites> StagingArea::stage(const Outcome& outcome) {
  for (const ChunkChanges& changes : outcome.chunks) {
    for (const VoxelChange& voxel : changes.voxels) {
      if (voxel.before != voxel.base) hash_.remove(changes.chunk, {voxel.index, voxel.before});
      if (voxel.after != voxel.base) hash_.add(changes.chunk, {voxel.index, voxel.after});
    }
  }
  std::vector<ChunkWrites> all = writes_at_all_levels(outcome.chunks);
  for (const ChunkWrites& writes : all) apply(writes);
  return all;
}

}  // namespace talus::edits
