// The memory of patches that nobody needs any more, for those that come. Callable from any thread.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include <talus/terrain/stacks.h>

#include "cache/patch_cache.h"

namespace talus::server {

/// A sixth of the time of a cold View went into memory fresh from the system: a page fault for every 4 KiB.
class SparePatches {
 public:
  explicit SparePatches(std::size_t most);

  /// A patch to be made: one of old, if there is one.
  [[nodiscard]] std::unique_ptr<terrain::Stacks> take();
  /// As it is from now on. When the last lets go of it, it comes back here; this must outlive that.
  [[nodiscard]] StacksPtr share(std::unique_ptr<terrain::Stacks> stacks);

 private:
  void give_back(std::unique_ptr<terrain::Stacks> stacks);

  std::mutex mutex_;
  std::size_t most_;
  std::vector<std::unique_ptr<terrain::Stacks>> spare_;
};

}  // namespace talus::server
