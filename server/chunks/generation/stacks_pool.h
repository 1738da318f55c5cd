// The memory of released patches, for the next patches. Callable from any thread.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include <talus/terrain/stacks.h>

namespace talus::server {

using StacksPtr = std::shared_ptr<const terrain::Stacks>;

/// A sixth of the time of a cold View was spent on memory fresh from the system: a page fault for every 4
/// KiB.
class StacksPool {
 public:
  /// Keeps at most `max_spare` unused patches.
  explicit StacksPool(std::size_t max_spare);

  /// Returns stacks to fill: spare ones, if there are any.
  [[nodiscard]] std::unique_ptr<terrain::Stacks> take();
  /// Makes filled stacks shared and immutable. When the last owner releases them they come back here; the
  /// pool must outlive that.
  [[nodiscard]] StacksPtr share(std::unique_ptr<terrain::Stacks> stacks);

 private:
  void give_back(std::unique_ptr<terrain::Stacks> stacks);

  std::mutex mutex_;
  const std::size_t max_spare_;
  std::vector<std::unique_ptr<terrain::Stacks>> spare_;
};

}  // namespace talus::server
