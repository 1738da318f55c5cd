// A map bounded in bytes that evicts by CLOCK (second chance): a hand goes round the entries and evicts the
// first that was not used since it last came by. So a use only sets a flag where the entry lies anyway, while
// a list in order of use would touch three more places in memory. For one thread; its users lock.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <new>
#include <type_traits>
#include <utility>

#include "chunks/cache/slot_table.h"

namespace talus::server {

template <typename Key, typename Value>
class ClockCache {
  static constexpr std::uint32_t kNone = SlotTable::kNone;
  static constexpr std::size_t kNotFound = SlotTable::kNotFound;
  struct Slot {
    Key key{};
    Value value{};
    std::size_t cost = 0;
    std::uint32_t tag = 0;  // in the table
    bool used = false;
  };

 public:
  /// What an entry costs beside the bytes of its value: its slot, and places of a table up to three quarters
  /// full.
  static constexpr std::size_t kEntryOverheadBytes = sizeof(Slot) + 2 * sizeof(SlotTable::Place);

  explicit ClockCache(std::size_t capacity_bytes) : capacity_bytes_{capacity_bytes} {}

  /// The value; null where there is none. Valid until the next change. A use.
  [[nodiscard]] const Value* find(const Key& key) { return find(key, std::hash<Key>{}(key)); }
  /// For who knows the key's hash already.
  [[nodiscard]] const Value* find(const Key& key, std::size_t hash) {
    const std::size_t at = place_of(key, static_cast<std::uint32_t>(hash));
    if (at == kNotFound) return nullptr;
    Slot& slot = slots_[table_.slot(at)];
    // A write where it is set already would take the cache line from every other core that reads it.
    if (!slot.used) slot.used = true;
    return &slot.value;
  }

  /// Not a use.
  [[nodiscard]] bool holds(const Key& key) const { return place_of(key, tag_of(key)) != kNotFound; }

  /// Keeps `value`, which costs `value_bytes`, in place of what the key had. A value that is larger than the
  /// whole capacity is not kept. Calls evicted(key, value) for each entry that is evicted for it, which must
  /// not throw and not use this cache; at most size() times, and not for what the key had. Throws
  /// std::bad_alloc, and then has changed nothing.
  ///
  /// Leaves no more bytes than the capacity, or than there were where that is less: what set_capacity() made
  /// too much is fit()'s work, not that of whoever comes first.
  template <typename Evicted>
  requires std::is_nothrow_invocable_v<Evicted&, const Key&, Value&&>
  void put(const Key& key, Value value, std::size_t value_bytes, Evicted&& evicted) {
    const std::size_t cost = value_bytes + kEntryOverheadBytes;
    const std::uint32_t tag = tag_of(key);
    const std::size_t before = place_of(key, tag);
    if (cost > capacity_bytes_) {
      if (before != kNotFound) remove(table_.slot(before));
      return;
    }
    // An entry in place of another, replaced or evicted, needs no slot or place beside that one's.
    const std::size_t most = std::max(capacity_bytes_, bytes_);
    std::uint32_t index = kNone;
    if (before != kNotFound) {
      index = table_.slot(before);
      bytes_ -= slots_[index].cost;
    } else if (bytes_ + cost <= most) {
      index = add_slot(tag);
    } else {
      index = next_victim(kNone);
      Slot& victim = slots_[index];
      bytes_ -= victim.cost;
      table_.erase(table_.place_of(victim.tag, index));
      table_.insert({tag, index});
      evicted(std::as_const(victim.key), std::move(victim.value));
    }
    slots_[index] = {key, std::move(value), cost, tag, false};
    bytes_ += cost;
    while (bytes_ > most) {
      const std::uint32_t victim = next_victim(index);
      const bool moves = index == slots_.size() - 1;
      const Key old = slots_[victim].key;
      evicted(old, remove(victim));
      if (moves) index = victim;
    }
  }
  void put(const Key& key, Value value, std::size_t value_bytes) {
    put(key, std::move(value), value_bytes, [](const Key&, Value&&) noexcept {});
  }

  /// No effect where there is none.
  void erase(const Key& key) {
    const std::size_t at = place_of(key, tag_of(key));
    if (at != kNotFound) remove(table_.slot(at));
  }

  /// Calls visit(key, value) for each entry. Not a use; `visit` must not use this cache.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for (const Slot& slot : slots_) visit(slot.key, slot.value);
  }

  /// Takes no time: call fit() until all fits.
  void set_capacity(std::size_t capacity_bytes) { capacity_bytes_ = capacity_bytes; }
  /// Evicts what is too much and gives its memory back. Looks at no more than `looks` entries, and takes what
  /// it looked at from `looks`. Whether all fits now.
  [[nodiscard]] bool fit(std::size_t& looks) {
    for (; bytes_ > capacity_bytes_; --looks) {
      if (looks == 0) return false;
      const std::uint32_t index = step();
      if (!std::exchange(slots_[index].used, false)) remove(index);
    }
    shrink_table();
    return true;
  }

  /// Of all entries, with their overhead.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t size() const { return slots_.size(); }

 private:
  // So that nothing but an allocation can throw.
  static_assert(std::is_nothrow_copy_constructible_v<Key> && std::is_nothrow_copy_assignable_v<Key> &&
                std::is_nothrow_move_constructible_v<Value> && std::is_nothrow_move_assignable_v<Value> &&
                std::is_nothrow_default_constructible_v<Value>);

  static std::uint32_t tag_of(const Key& key) { return static_cast<std::uint32_t>(std::hash<Key>{}(key)); }
  [[nodiscard]] std::size_t place_of(const Key& key, std::uint32_t tag) const {
    return table_.find(tag, [&](std::uint32_t slot) { return slots_[slot].key == key; });
  }

  /// A slot and a place for one entry more. All that put() allocates.
  std::uint32_t add_slot(std::uint32_t tag) {
    table_.grow_for(slots_.size() + 1);
    slots_.emplace_back();
    const auto index = static_cast<std::uint32_t>(slots_.size() - 1);
    table_.insert({tag, index});
    return index;
  }

  /// Where the table is much larger than its entries need, and there is memory for a smaller one.
  void shrink_table() {
    try {
      table_.shrink_for(slots_.size());
    } catch (const std::bad_alloc&) {
      return;  // the next fit() tries again
    }
  }

  /// The slot under the hand, which moves on.
  std::uint32_t step() {
    const std::uint32_t index = hand_;
    hand_ = index + 1 < slots_.size() ? index + 1 : 0;
    return index;
  }
  /// There is another entry than `kept`.
  std::uint32_t next_victim(std::uint32_t kept) {
    for (;;) {
      const std::uint32_t index = step();
      if (!std::exchange(slots_[index].used, false) && index != kept) return index;
    }
  }

  /// The last entry moves into the place. Where it moves behind the hand, it stays a round longer.
  Value remove(std::uint32_t index) noexcept {
    Slot& slot = slots_[index];
    bytes_ -= slot.cost;
    Value value = std::move(slot.value);
    table_.erase(table_.place_of(slot.tag, index));
    const auto last = static_cast<std::uint32_t>(slots_.size() - 1);
    if (index != last) {
      table_.set_slot(table_.place_of(slots_[last].tag, last), index);
      slot = std::move(slots_[last]);
    }
    slots_.pop_back();
    if (hand_ == last) hand_ = 0;
    return value;
  }

  std::size_t capacity_bytes_;
  std::size_t bytes_ = 0;
  std::uint32_t hand_ = 0;
  std::deque<Slot> slots_;  // a deque, so that growing moves nothing
  SlotTable table_;
};

}  // namespace talus::server
