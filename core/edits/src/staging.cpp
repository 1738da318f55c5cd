#include <talus/edits/staging.h>

#include <algorithm>
#include <map>
#include <utility>

namespace talus::edits {

std::vector<ChunkWrites> writes_at_all_levels(std::span<const ChunkChanges> changes) {
  std::vector<ChunkWrites> all;
  all.reserve(changes.size());
  // Several base chunks share a coarse one, each with voxels anywhere in it.
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

const ChunkOverrides* Staging::find(ChunkKey chunk) const {
  const auto staged = chunks_.find(chunk);
  if (staged == chunks_.end()) return applied_.find(chunk);
  return staged->second.empty() ? nullptr : &staged->second;
}

void Staging::apply(const ChunkWrites& writes) {
  const auto [at, added] = chunks_.try_emplace(writes.key);
  if (added) {
    if (const ChunkOverrides* const before = applied_.find(writes.key)) at->second = *before;
  }
  at->second.apply(writes.writes);
}

std::vector<ChunkWrites> Staging::stage(const Outcome& outcome) {
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
