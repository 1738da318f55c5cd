#include <talus/edits/chunk_overrides.h>

#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

namespace talus::edits {
namespace {

[[maybe_unused]] bool rises(auto voxels) {
  return std::ranges::adjacent_find(voxels, std::greater_equal{},
                                    [](const auto& each) { return each.index; }) == voxels.end() &&
         (voxels.empty() || voxels.back().index < kChunkVolume);
}

/// One search, and at most one move of the tail.
void write_one(std::vector<Override>& voxels, const OverrideWrite& write) {
  const auto at = std::ranges::lower_bound(voxels, write.index, {}, &Override::index);
  const bool found = at != voxels.end() && at->index == write.index;
  if (!write.material) {
    if (found) voxels.erase(at);
  } else if (found) {
    at->material = *write.material;
  } else {
    voxels.insert(at, Override{write.index, *write.material});
  }
}

std::vector<Override> merge(std::span<const Override> voxels, std::span<const OverrideWrite> writes) {
  std::vector<Override> merged;
  merged.reserve(std::min<std::size_t>(voxels.size() + writes.size(), kChunkVolume));
  auto kept = voxels.begin();
  for (const OverrideWrite& write : writes) {
    for (; kept != voxels.end() && kept->index < write.index; ++kept) merged.push_back(*kept);
    if (kept != voxels.end() && kept->index == write.index) ++kept;
    if (write.material) merged.push_back({write.index, *write.material});
  }
  merged.insert(merged.end(), kept, voxels.end());
  return merged;
}

}  // namespace

ChunkOverrides::ChunkOverrides(std::vector<Override> voxels) : voxels_{std::move(voxels)} {
  assert(rises(std::span{std::as_const(voxels_)}));
}

std::optional<MaterialId> ChunkOverrides::find(std::uint16_t index) const {
  const auto at = std::ranges::lower_bound(voxels_, index, {}, &Override::index);
  if (at == voxels_.end() || at->index != index) return std::nullopt;
  return at->material;
}

void ChunkOverrides::apply(std::span<const OverrideWrite> writes) {
  assert(rises(writes));
  // Moving n voxels costs about a sixteenth of merging n voxels one by one.
  if (writes.size() * 16 < voxels_.size()) {
    for (const OverrideWrite& write : writes) write_one(voxels_, write);
  } else {
    voxels_ = merge(voxels_, writes);
  }
}

}  // namespace talus::edits
