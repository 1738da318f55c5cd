// A map by request id for short-lived entries: a table of a power of two slots with linear probing. No nodes
// are allocated and nothing is divided, unlike in std::unordered_map.
//
// Clients choose their ids. To prevent them from choosing ids that collide, the order in the table depends on
// a random number of this process.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace talus::server {

/// Ids begin at 1; 0 is never a key.
template <typename Value>
class IdMap {
 public:
  IdMap() : IdMap{random_secret()} {}
  explicit IdMap(std::uint32_t secret) : secret_{secret} {}

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Memory of the table, which shrinks only when the map is empty.
  [[nodiscard]] std::size_t bytes() const { return slots_.capacity() * sizeof(Slot); }
  [[nodiscard]] bool empty() const { return size_ == 0; }

  /// Null if not found. Valid until the next change.
  [[nodiscard]] const Value* find(std::uint32_t id) const {
    const std::size_t at = index_of(id);
    return at == kNotFound ? nullptr : &slots_[at].value;
  }

  /// REQUIRES: the map has no `id`, which is not 0.
  void insert(std::uint32_t id, Value value) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    place(id, std::move(value));
    ++size_;
  }

  /// No effect if not found. Frees a large table that becomes empty.
  void erase(std::uint32_t id) {
    const std::size_t at = index_of(id);
    if (at == kNotFound) return;
    close_gap(at);
    if (--size_ == 0 && slots_.size() > kMaxIdleSlots) clear();
  }

  void clear() { *this = IdMap{secret_}; }

  /// Calls visit(id, value) for each entry, in unspecified order.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for (const Slot& slot : slots_) {
      if (slot.id != kVacant) visit(slot.id, slot.value);
    }
  }

 private:
  static_assert(std::is_trivially_destructible_v<Value>, "a vacant slot keeps its last value");
  struct Slot {
    std::uint32_t id = kVacant;
    Value value{};
  };
  static constexpr std::uint32_t kVacant = 0;
  static constexpr std::size_t kNotFound = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t kMinSlots = 16;
  static constexpr std::size_t kMaxIdleSlots = 128;

  // Clients use ascending ids. Stored side by side they would form one long run, which every erase() would
  // walk; multiplied by 2^32 over the golden ratio they lie apart.
  [[nodiscard]] std::size_t home_of(std::uint32_t id) const {
    return ((id ^ secret_) * 0x9E3779B9U) >> shift_;
  }
  [[nodiscard]] std::size_t after(std::size_t at) const { return (at + 1) & (slots_.size() - 1); }

  [[nodiscard]] std::size_t index_of(std::uint32_t id) const {
    if (id == kVacant || slots_.empty()) return kNotFound;
    std::size_t at = home_of(id);
    while (slots_[at].id != id) {
      if (slots_[at].id == kVacant) return kNotFound;
      at = after(at);
    }
    return at;
  }

  void place(std::uint32_t id, Value&& value) {
    std::size_t at = home_of(id);
    while (slots_[at].id != kVacant) at = after(at);
    slots_[at].id = id;
    slots_[at].value = std::move(value);
  }

  void grow() {
    std::vector<Slot> before(slots_.empty() ? kMinSlots : 2 * slots_.size());
    before.swap(slots_);
    shift_ = 32 - std::countr_zero(slots_.size());
    for (Slot& slot : before) {
      if (slot.id != kVacant) place(slot.id, std::move(slot.value));
    }
  }

  /// Moves up entries after the gap that could no longer be found.
  void close_gap(std::size_t gap) {
    for (std::size_t at = after(gap); slots_[at].id != kVacant; at = after(at)) {
      const std::size_t way_from_home = (at - home_of(slots_[at].id)) & (slots_.size() - 1);
      const std::size_t way_from_gap = (at - gap) & (slots_.size() - 1);
      if (way_from_home < way_from_gap) continue;
      slots_[gap] = std::move(slots_[at]);
      gap = at;
    }
    slots_[gap].id = kVacant;
  }

  static std::uint32_t random_secret() {
    static const std::uint32_t secret = std::random_device{}();
    return secret;
  }

  std::uint32_t secret_;
  std::vector<Slot> slots_;  // a power of two of them, or empty
  std::size_t size_ = 0;
  int shift_ = 32;  // of the product: the remaining bits are the slot's index
};

}  // namespace talus::server
