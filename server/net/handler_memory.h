// Memory for one asynchronous operation that is there before the operation begins, so that it can begin
// where the process has no memory left.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace talus::server {

/// One block, which a second operation does not find free. One thread's.
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
  // Asio's operations for an acceptor's handlers take about a quarter of it.
  alignas(std::max_align_t) std::array<std::byte, 1024> block_;
  bool taken_ = false;
};

/// Asio's allocator for a handler. The operation shares the memory, which lives as long as either of them. An
/// allocator that was moved from still frees, as Asio wants where an operation cannot begin: so it only
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
