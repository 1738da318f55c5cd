// Memory for one asynchronous operation, allocated before it begins, so that it can begin when the process is
// out of memory.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace talus::server {

/// One block; a second concurrent operation allocates its own memory. For one thread.
class HandlerMemory {
 public:
  [[nodiscard]] void* take(std::size_t bytes) {
    if (taken_ || bytes > sizeof(block_)) return ::operator new(bytes);
    taken_ = true;
    return block_.data();
  }
  void give_back(void* memory) noexcept {
    if (memory != block_.data()) return ::operator delete(memory);
    taken_ = false;
  }

 private:
  // Asio's operations for an acceptor's handlers use about a quarter of it.
  alignas(std::max_align_t) std::array<std::byte, 1024> block_;
  bool taken_ = false;
};

/// Asio's allocator for a handler. The operation shares the memory, which lives as long as either of them. A
/// moved-from allocator must still free memory (Asio does this if an operation cannot begin), so moving
/// copies.
template <typename Value>
class HandlerAllocator {
 public:
  using value_type = Value;

  explicit HandlerAllocator(std::shared_ptr<HandlerMemory> memory) noexcept : memory_{std::move(memory)} {}
  HandlerAllocator(const HandlerAllocator&) noexcept = default;
  HandlerAllocator& operator=(const HandlerAllocator&) noexcept = default;
  template <typename Other>
  HandlerAllocator(const HandlerAllocator<Other>& other) noexcept : memory_{other.memory_} {}

  [[nodiscard]] Value* allocate(std::size_t count) const {
    static_assert(alignof(Value) <= alignof(std::max_align_t));
    return static_cast<Value*>(memory_->take(count * sizeof(Value)));
  }
  void deallocate(Value* memory, std::size_t) const noexcept { memory_->give_back(memory); }

  template <typename Other>
  [[nodiscard]] bool operator==(const HandlerAllocator<Other>& other) const noexcept {
    return memory_ == other.memory_;
  }

 private:
  template <typename Other>
  friend class HandlerAllocator;

  std::shared_ptr<HandlerMemory> memory_;
};

}  // namespace talus::server
