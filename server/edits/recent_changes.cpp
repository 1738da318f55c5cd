#include "edits/recent_changes.h"

#include <algorithm>
#include <mutex>

namespace talus::server {
namespace {

/// Of a change with its places in the map and in the order.
constexpr std::size_t kChangeBytes = 200;

}  // namespace

void RecentChanges::add(std::vector<Change> changes) {
  const std::lock_guard lock{mutex_};
  for (Change& change : changes) {
    if (change.voxels.empty() || change.voxels.size() > kMostVoxels) {
      chunks_.erase(change.key);
      continue;
    }
    const std::size_t size = kChangeBytes + change.voxels.size() * sizeof(Override);
    order_.emplace_back(change.key, change.revision);
    sizes_.push_back(size);
    bytes_ += size;
    chunks_[change.key].push_back(std::move(change));
  }
  while (bytes_ > capacity_bytes_) forget_oldest();
}

void RecentChanges::forget_oldest() {
  const auto [key, revision] = order_.front();
  order_.pop_front();
  bytes_ -= sizes_.front();
  sizes_.pop_front();
  const auto found = chunks_.find(key);
  if (found == chunks_.end() || found->second.front().revision != revision) return;
  found->second.pop_front();
  if (found->second.empty()) chunks_.erase(found);
}

std::optional<AppliedEdits::Changes> RecentChanges::since(ChunkKey key, std::uint64_t since,
                                                          std::size_t most) const {
  const std::shared_lock lock{mutex_};
  const auto found = chunks_.find(key);
  if (found == chunks_.end()) return std::nullopt;
  const std::deque<Change>& changes = found->second;
  const auto first = std::ranges::upper_bound(changes, since, {}, &Change::revision);
  if (first == changes.end() || first->previous > since) return std::nullopt;

  AppliedEdits::Changes all{.revision = changes.back().revision, .voxels = {}};
  for (auto at = first; at != changes.end(); ++at) {
    // Voxels that change again and again count once, but not for ever.
    if (all.voxels.size() + at->voxels.size() > 4 * (most + kMostVoxels)) return std::nullopt;
    all.voxels.insert(all.voxels.end(), at->voxels.begin(), at->voxels.end());
  }
  // Of one voxel's changes the last one stays.
  std::ranges::reverse(all.voxels);
  std::ranges::stable_sort(all.voxels, {}, &Override::index);
  const auto same = [](Override a, Override b) { return a.index == b.index; };
  all.voxels.erase(std::unique(all.voxels.begin(), all.voxels.end(), same), all.voxels.end());
  if (all.voxels.size() > most) return std::nullopt;
  return all;
}

}  // namespace talus::server
