#include <talus/edits/staging.h>

#include <map>
#include <utility>

namespace talus::edits {

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
  std::vector<ChunkWrites> all;
  // Several base chunks share a coarse one, each with voxels anywhere in it: there they are put in order.
  std::map<ChunkKey, std::map<std::uint16_t, OverrideWrite>> coarse;
  for (const ChunkChanges& changes : outcome.chunks) {
    for (const VoxelChange& voxel : changes.voxels) {
      if (voxel.before != voxel.base) hash_.remove(changes.chunk, {voxel.index, voxel.before});
      if (voxel.after != voxel.base) hash_.add(changes.chunk, {voxel.index, voxel.after});
    }
    all.push_back({{changes.chunk, Lod{}}, writes_of(changes)});
    for (const ChunkWrites& each : coarse_writes(changes.chunk, all.back().writes)) {
      for (const OverrideWrite& write : each.writes) coarse[each.key].emplace(write.index, write);
    }
  }
  for (const auto& [key, writes] : coarse) {
    ChunkWrites of_chunk{key, {}};
    for (const auto& [index, write] : writes) of_chunk.writes.push_back(write);
    all.push_back(std::move(of_chunk));
  }
  for (const ChunkWrites& writes : all) apply(writes);
  return all;
}

}  // namespace talus::edits
