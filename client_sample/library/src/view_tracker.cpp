#include "view_tracker.h"

#include <algorithm>
#include <utility>

namespace talus::client {

std::vector<ChunkKey> ViewTracker::replace(const View& view, HeightRange heights) {
  view_ = view;
  shape_ = ViewShape{view, heights};
  std::vector<ChunkKey> left;
  for (const auto& [key, chunk] : delivered_) {
    if (shape_.covers(key)) continue;
    left.push_back(key);
    const auto held = still_there(key, chunk);
    // A uniform chunk is cheap to send again.
    if (keep_bytes_ > 0 && has_current(key) && held && !held->chunk->is_uniform()) kept_.put(*held);
  }
  for (const auto& key : left) {
    delivered_.erase(key);
    outdated_.erase(key);
  }
  return left;
}

bool ViewTracker::deliver(const ReceivedChunk& chunk) {
  const auto before = delivered_.find(chunk.key);
  if (before != delivered_.end() && before->second.revision > chunk.revision) return false;
  kept_.erase(chunk.key);
  outdated_.erase(chunk.key);
  delivered_[chunk.key] = {chunk.revision, chunk.hash, chunk.chunk};
  return true;
}

void ViewTracker::forget_revisions() {
  for (auto& [key, chunk] : delivered_) chunk.revision = 0;
  std::vector<ReceivedChunk> kept;
  kept_.for_each([&kept](const ReceivedChunk& chunk) { kept.push_back(chunk); });
  for (ReceivedChunk& chunk : kept) {
    chunk.revision = 0;
    kept_.erase(chunk.key);
    kept_.put(chunk);
  }
}

void ViewTracker::outdate_edited() {
  for (const auto& [key, chunk] : delivered_) {
    if (chunk.revision != 0) outdated_.insert(key);
  }
  std::vector<ChunkKey> edited;
  kept_.for_each([&edited](const ReceivedChunk& chunk) {
    if (chunk.revision != 0) edited.push_back(chunk.key);
  });
  for (const ChunkKey& key : edited) kept_.erase(key);
  forget_revisions();
}

std::optional<ContentHash> ViewTracker::generated_hash(const ChunkKey& key) const {
  const auto found = delivered_.find(key);
  if (found == delivered_.end() || found->second.revision != 0 || outdated_.contains(key))
    return std::nullopt;
  return found->second.hash;
}

std::optional<ReceivedChunk> ViewTracker::still_there(const ChunkKey& key, const DeliveredChunk& chunk) {
  auto held = chunk.chunk.lock();
  if (held == nullptr) return std::nullopt;
  return ReceivedChunk{key, chunk.revision, chunk.hash, std::move(held)};
}

std::optional<ReceivedChunk> ViewTracker::held(const ChunkKey& key) const {
  if (const ReceivedChunk* kept = kept_.look(key)) return *kept;
  const auto found = delivered_.find(key);
  return !has_current(key) ? std::nullopt : still_there(key, found->second);
}

std::vector<ReceivedChunk> ViewTracker::known(std::size_t max, bool with_delivered) const {
  std::vector<ReceivedChunk> known;
  const auto add = [&](const ReceivedChunk& chunk) {
    if (known.size() < max && shape_.covers(chunk.key) && !chunk.chunk->is_uniform()) known.push_back(chunk);
  };
  kept_.for_each(add);
  if (!with_delivered) return known;
  for (const auto& [key, chunk] : delivered_) {
    if (outdated_.contains(key)) continue;
    if (const auto held = still_there(key, chunk)) add(*held);
  }
  return known;
}

std::vector<ChunkKey> ViewTracker::missing() const {
  std::vector<ChunkKey> missing;
  if (complete()) return missing;
  shape_.for_each([&](const ChunkKey& key) {
    if (!has_current(key)) missing.push_back(key);
  });
  return missing;
}

}  // namespace talus::client
