// Renames that fail, as on a disk that is full.
#pragma once

#include <cstddef>

namespace talus::test {

/// While it lives one of this program's renames fails, of any thread: the one after `renames` that are done.
class FailingRenames {
 public:
  explicit FailingRenames(std::size_t renames);
  ~FailingRenames();
  FailingRenames(const FailingRenames&) = delete;
  FailingRenames& operator=(const FailingRenames&) = delete;

  [[nodiscard]] bool has_failed() const;
};

}  // namespace talus::test
