// Memory aligned to a cache line, so that no vector of a row that starts there straddles two lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

namespace talus {

/// Size of the largest vector of any instruction set, and of a cache line.
inline constexpr std::size_t kVectorBytes = 64;

/// Allocates memory aligned to kVectorBytes, for the standard containers.
template <class T>
struct AlignedAllocator {
  static_assert(alignof(T) <= kVectorBytes);
  using value_type = T;

  AlignedAllocator() = default;
  template <class U>
  explicit(false) AlignedAllocator(const AlignedAllocator<U>& /*other*/) {}

  // Over-allocates and aligns by hand: glibc does not reuse freed blocks for aligned requests, so its heaps
  // grow. The pointer just before the first element holds the start of the allocation.
  [[nodiscard]] T* allocate(std::size_t count) {
    static_assert(__STDCPP_DEFAULT_NEW_ALIGNMENT__ >= sizeof(void*));
    void* const memory = ::operator new(count * sizeof(T) + kVectorBytes);
    const std::size_t past_line = reinterpret_cast<std::uintptr_t>(memory) % kVectorBytes;
    auto* const elements =
        reinterpret_cast<void**>(static_cast<std::byte*>(memory) + kVectorBytes - past_line);
    elements[-1] = memory;
    return reinterpret_cast<T*>(elements);
  }
  void deallocate(T* elements, std::size_t /*count*/) {
    ::operator delete(reinterpret_cast<void**>(elements)[-1]);
  }
  bool operator==(const AlignedAllocator& /*other*/) const { return true; }
};

/// A std::vector whose elements start at a cache line.
template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

/// Like AlignedAllocator, but elements are default-initialized: growing costs only the allocation.
template <class T>
struct UnsetAllocator : AlignedAllocator<T> {
  using value_type = T;

  UnsetAllocator() = default;
  template <class U>
  explicit(false) UnsetAllocator(const UnsetAllocator<U>& /*other*/) {}

  template <class U>
  void construct(U* element) {
    ::new (static_cast<void*>(element)) U;
  }
  template <class U, class... Values>
  void construct(U* element, Values&&... values) {
    ::new (static_cast<void*>(element)) U(std::forward<Values>(values)...);
  }
};

}  // namespace talus
