#include "cache/patch_cache.h"

#include <utility>

namespace talus::server {

PatchCache::PatchCache(std::size_t capacity_bytes) : patches_{capacity_bytes} {}

StacksPtr PatchCache::find(const PatchKey& key) {
  const std::lock_guard lock{mutex_};
  const StacksPtr* stacks = patches_.find(key);
  return stacks == nullptr ? nullptr : *stacks;
}

bool PatchCache::holds(const PatchKey& key) const {
  const std::lock_guard lock{mutex_};
  return patches_.holds(key);
}

DroppedPatches PatchCache::put(const PatchKey& key, StacksPtr stacks) {
  const std::size_t bytes = stacks->bytes();
  DroppedPatches dropped;
  const std::lock_guard lock{mutex_};
  patches_.put(key, std::move(stacks), bytes,
               [&](const PatchKey& old, StacksPtr&& gone) { dropped.emplace_back(old, std::move(gone)); });
  return dropped;
}

void PatchCache::drop(const PatchKey& key) {
  const std::lock_guard lock{mutex_};
  patches_.erase(key);
}

void PatchCache::set_capacity(std::size_t capacity_bytes) {
  const std::lock_guard lock{mutex_};
  patches_.set_capacity(capacity_bytes);
}

std::size_t PatchCache::bytes() const {
  const std::lock_guard lock{mutex_};
  return patches_.bytes();
}

}  // namespace talus::server
