// Stacks of patches in memory, bounded in bytes. Callable from any thread.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <talus/terrain/stacks.h>

#include "cache/lru.h"
#include "generation/patch.h"

namespace talus::server {

using StacksPtr = std::shared_ptr<const terrain::Stacks>;

using DroppedPatches = std::vector<std::pair<PatchKey, StacksPtr>>;

class PatchCache {
 public:
  explicit PatchCache(std::size_t capacity_bytes);

  /// Null where the patch is not held.
  [[nodiscard]] StacksPtr find(const PatchKey& key);
  /// Not a use.
  [[nodiscard]] bool holds(const PatchKey& key) const;
  /// Returns the patches that had to make room.
  [[nodiscard]] DroppedPatches put(const PatchKey& key, StacksPtr stacks);
  void drop(const PatchKey& key);
  /// Forgets at once what is too much.
  void set_capacity(std::size_t capacity_bytes);
  [[nodiscard]] std::size_t bytes() const;

 private:
  mutable std::mutex mutex_;
  Lru<PatchKey, StacksPtr> patches_;
};

}  // namespace talus::server
