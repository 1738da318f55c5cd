#include "edits/recent_changes.h"

#include <algorithm>
#include <mutex>

namespace talus::server {
namespace {

std::size_t bytes_of_change(const RecentChanges::Change& change) {
  return 64 + change.voxels * sizeof(Override);
}

}  // namespace

void RecentChanges::add(std::span<const Change> changes, std::span<const Override> voxels) {
  const std::lock_guard lock{mutex_};
  for (const Change& change : changes) {
    bytes_ += bytes_of_change(change);
    changes_.push_back({change, oldest_voxel_ + voxels_.size()});
    voxels_.insert(voxels_.end(), voxels.begin(), voxels.begin() + change.voxels);
    voxels = voxels.subspan(change.voxels);
  }
  while (bytes_ > capacity_bytes_) forget_oldest();
}

void RecentChanges::forget_oldest() {
  const Change& change = changes_.front().change;
  bytes_ -= bytes_of_change(change);
  voxels_.erase(voxels_.begin(), voxels_.begin() + change.voxels);
  oldest_voxel_ += change.voxels;
  changes_.pop_front();
  ++oldest_;
}

const RecentChanges::StoredChange* RecentChanges::find(ChunkKey key, ChunkIndex::ChunkEntry edited) const {
  const std::size_t place = edited.change - oldest_;
  if (place >= changes_.size()) return nullptr;
  const StoredChange& found = changes_[place];
  return found.change.key == key && found.change.revision == edited.revision ? &found : nullptr;
}

std::optional<AppliedEdits::Changes> RecentChanges::since(ChunkKey key, ChunkIndex::ChunkEntry now,
                                                          std::uint64_t since, std::size_t max_voxels) const {
  const std::shared_lock lock{mutex_};
  AppliedEdits::Changes all{.revision = now.revision, .voxels = {}};
  // From the newest change to the first after `since`.
  while (now.revision > since) {
    const StoredChange* const found = find(key, now);
    if (found == nullptr) return std::nullopt;
    const Change& change = found->change;
    // Voxels that change repeatedly count once, up to this bound.
    if (all.voxels.size() + change.voxels > 4 * (max_voxels + kMaxVoxels)) return std::nullopt;
    const auto first = voxels_.begin() + static_cast<std::ptrdiff_t>(found->first_voxel - oldest_voxel_);
    all.voxels.insert(all.voxels.end(), first, first + change.voxels);
    now = {change.previous, change.before};
  }
  // Keeps the newest change of each voxel.
  std::ranges::stable_sort(all.voxels, {}, &Override::index);
  const auto same = [](Override a, Override b) { return a.index == b.index; };
  all.voxels.erase(std::unique(all.voxels.begin(), all.voxels.end(), same), all.voxels.end());
  if (all.voxels.size() > max_voxels) return std::nullopt;
  return all;
}

}  // namespace talus::server
