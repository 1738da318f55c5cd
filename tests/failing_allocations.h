// Lets an allocation of the test's own thread fail. A program has it by compiling failing_allocations.cpp.
#pragma once

#include <cstddef>

namespace talus::test {

/// While this lives, operator new of this thread serves `allocations` times, and then throws std::bad_alloc
/// once. Allocations of less than `from_bytes` are served and do not count. One at a time in a thread.
class FailingAllocations {
 public:
  explicit FailingAllocations(std::size_t allocations, std::size_t from_bytes = 0);
  ~FailingAllocations();
  FailingAllocations(const FailingAllocations&) = delete;
  FailingAllocations& operator=(const FailingAllocations&) = delete;

  [[nodiscard]] bool has_failed() const;
};

}  // namespace talus::test
