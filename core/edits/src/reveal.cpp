#include "reveal.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "visit.h"

namespace talus::edits {
namespace {

template <typename Voxels>
auto* find_voxel(Voxels&& voxels, std::uint16_t index) {
  const auto at =
      std::lower_bound(voxels.begin(), voxels.end(), index,
                       [](const auto& voxel, std::uint16_t wanted) { return voxel.index < wanted; });
  return at == voxels.end() || at->index != index ? nullptr : &*at;
}

/// The state after an edit.
class StateAfter {
 public:
  StateAfter(const std::vector<ChunkChanges>& changes, const OverrideSource& overrides)
      : changes_{changes}, overrides_{overrides} {}

  /// The voxel's change; null if the edit does not change it.
  [[nodiscard]] const VoxelChange* change(ChunkCoord chunk, std::uint16_t index) const {
    const auto at = std::ranges::lower_bound(changes_, chunk, {}, &ChunkChanges::chunk);
    return at == changes_.end() || at->chunk != chunk ? nullptr : find_voxel(at->voxels, index);
  }
  /// The voxel's override; nullopt if it is as generated.
  [[nodiscard]] std::optional<MaterialId> edited(ChunkCoord chunk, std::uint16_t index) const {
    if (const VoxelChange* const change = this->change(chunk, index)) {
      return change->after == change->base ? std::nullopt : std::optional{change->after};
    }
    const ChunkKey key{chunk, Lod{}};
    if (const OverrideWrite* const write = find_voxel(overrides_.staged(key), index)) return write->material;
    const ChunkOverrides* const applied = overrides_.find(key);
    return applied == nullptr ? std::nullopt : applied->find(index);
  }

 private:
  const std::vector<ChunkChanges>& changes_;
  const OverrideSource& overrides_;
};

bool is_exposed(VoxelPos voxel, const StateAfter& state, const std::vector<MaterialId>& see_through) {
  bool exposed = false;
  visit_beside(voxel, [&](VoxelPos beside) {
    if (exposed || !chunk_holding(beside, Lod{})) return;
    const auto edited = state.edited(chunk_of(beside), index_of(beside));
    exposed = edited && std::ranges::binary_search(see_through, *edited);
  });
  return exposed;
}

/// Adds `revealed`, by ascending index, to the changes of a chunk; they replace those of the same voxels.
void merge(std::vector<VoxelChange> revealed, std::vector<VoxelChange>& voxels) {
  std::erase_if(voxels,
                [&](const VoxelChange& voxel) { return find_voxel(revealed, voxel.index) != nullptr; });
  const auto middle = static_cast<std::ptrdiff_t>(voxels.size());
  voxels.insert(voxels.end(), revealed.begin(), revealed.end());
  std::ranges::inplace_merge(voxels, voxels.begin() + middle, {}, &VoxelChange::index);
}

}  // namespace

void reveal(const SecretVoxels& secrets, const OverrideSource& overrides,
            std::vector<ChunkChanges>& changes) {
  const StateAfter state{changes, overrides};
  std::vector<ChunkChanges> revealed;
  for (const auto& [chunk, hidden] : secrets.hidden) {
    const auto base = secrets.base.find(chunk);
    if (base == secrets.base.end()) continue;
    ChunkChanges of_chunk{chunk, {}};
    for (const Override& secret : hidden) {
      const Override* const shown = find_voxel(base->second, secret.index);
      if (shown == nullptr || state.edited(chunk, secret.index)) continue;
      if (!is_exposed(voxel_at(chunk_origin(chunk), local_of(secret.index)), state, secrets.see_through))
        continue;
      const VoxelChange* const change = state.change(chunk, secret.index);
      const MaterialId before = change == nullptr ? shown->material : change->before;
      of_chunk.voxels.push_back({secret.index, before, secret.material, shown->material});
    }
    if (!of_chunk.voxels.empty()) revealed.push_back(std::move(of_chunk));
  }
  for (ChunkChanges& each : revealed) {
    const auto at = std::ranges::lower_bound(changes, each.chunk, {}, &ChunkChanges::chunk);
    if (at == changes.end() || at->chunk != each.chunk) {
      changes.insert(at, std::move(each));
    } else {
      merge(std::move(each.voxels), at->voxels);
    }
  }
}

}  // namespace talus::edits
