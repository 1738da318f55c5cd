#include "failing_allocations.h"

#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();
thread_local std::size_t left = kNever;  // until the allocation that fails
thread_local std::size_t counted_from_bytes = 0;
thread_local bool failed = false;

}  // namespace

// The forms of arrays call these. Those that throw nothing are here too, for what one form allocates another
// may free.
void* operator new(std::size_t size) {
  if (left != kNever && size >= counted_from_bytes && left-- == 0) {
    left = kNever;
    failed = true;
    throw std::bad_alloc{};
  }
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc{};
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return ::operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}

namespace talus::test {

FailingAllocations::FailingAllocations(std::size_t allocations, std::size_t from_bytes) {
  left = allocations;
  counted_from_bytes = from_bytes;
  failed = false;
}

FailingAllocations::~FailingAllocations() {
  left = kNever;
}

bool FailingAllocations::has_failed() const {
  return failed;
}

}  // namespace talus::test
