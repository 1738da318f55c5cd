#include "edits/recent_changes.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace talus::server {
namespace {

/// Of a change with its places.
std::size_t bytes_of_change(const RecentChanges::Change& change) {
  return 160 + change.voxels.size() * sizeof(Override);
}

}  // namespace

void RecentChanges::add(std::vector<Change> changes) {
  const std::lock_guard lock{mutex_};
  for (Change& change : changes) {
    if (change.voxels.empty() || change.voxels.size() > kMostVoxels) {
      newest_.erase(change.key);
      continue;
    }
    bytes_ += bytes_of_change(change);
    std::uint64_t& newest = newest_[change.key];
    const std::uint64_t before = std::exchange(newest, oldest_ + changes_.size());
    changes_.push_back({std::move(change), before});
  }
  while (bytes_ > capacity_bytes_) forget_oldest();
}

void RecentChanges::forget_oldest() {
  const Change& change = changes_.front().change;
  bytes_ -= bytes_of_change(change);
  const std::uint64_t* const newest = newest_.find(change.key);
  if (newest != nullptr && *newest == oldest_) newest_.erase(change.key);
  changes_.pop_front();
  ++oldest_;
}

std::optional<AppliedEdits::Changes> RecentChanges::since(ChunkKey key, std::uint64_t since,
                                                          std::size_t most) const {
  const std::shared_lock lock{mutex_};
  const std::uint64_t* const newest = newest_.find(key);
  if (newest == nullptr) return std::nullopt;
  AppliedEdits::Changes all{.revision = changes_[*newest - oldest_].change.revision, .voxels = {}};
  if (all.revision <= since) return std::nullopt;
  // From the newest change to the first after `since`.
  for (std::uint64_t number = *newest;;) {
    if (number < oldest_) return std::nullopt;
    const auto& [change, before] = changes_[number - oldest_];
    // Voxels that change again and again count once, but not for ever.
    if (all.voxels.size() + change.voxels.size() > 4 * (most + kMostVoxels)) return std::nullopt;
    all.voxels.insert(all.voxels.end(), change.voxels.begin(), change.voxels.end());
    if (change.previous <= since) break;
    number = before;
  }
  // Of one voxel's changes the newest stays.
  std::ranges::stable_sort(all.voxels, {}, &Override::index);
  const auto same = [](Override a, Override b) { return a.index == b.index; };
  all.voxels.erase(std::unique(all.voxels.begin(), all.voxels.end(), same), all.voxels.end());
  if (all.voxels.size() > most) return std::nullopt;
  return all;
}

}  // namespace talus::server
