// A map bounded in bytes that evicts by CLOCK (second chance): a hand circles over the entries and evicts the
// first that was not used since its last pass. So a use only sets a flag in the entry, while an LRU list
// would touch three more places in memory. For one thread; its users lock.
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
  /// Cost of an entry in addition to its value's bytes: its slot, and its share of a table that is up to
  /// three quarters full.
  static constexpr std::size_t kEntryOverheadBytes = sizeof(Slot) + 2 * sizeof(SlotTable::Place);

  explicit ClockCache(std::size_t capacity_bytes) : capacity_bytes_{capacity_bytes} {}

  /// Returns the value; null if not found. Valid until the next change. Counts as a use.
  [[nodiscard]] const Value* find(const Key& key) { return find(key, std::hash<Key>{}(key)); }
  /// For callers that already have the key's hash.
  [[nodiscard]] const Value* find(const Key& key, std::size_t hash) {
    const std::size_t at = place_of(key, static_cast<std::uint32_t>(hash));
    if (at == kNotFound) return nullptr;
    Slot& slot = slots_[table_.slot(at)];
    // Writing it again would take the cache line from every other core that reads it.
    if (!slot.used) slot.used = true;
    return &slot.value;
  }

  /// Does not count as a use.
  [[nodiscard]] bool holds(const Key& key) const { return place_of(key, tag_of(key)) != kNotFound; }

  /// Stores `value`, which costs `value_bytes`, replacing the key's old value. A value larger than the whole
  /// capacity is not stored. Calls evicted(key, value) for each entry evicted to make room (at most size()
  /// times, and not for the replaced value); it must not throw or use this cache. Throws std::bad_alloc
  /// without changing anything.
  ///
  /// Leaves no more bytes than the capacity, or than before the call if there were more: an excess caused by
  /// set_capacity() is left to fit(), not charged to the next caller.
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
    // An entry that replaces another, old or evicted, reuses its slot and place.
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

  /// No effect if not found.
  void erase(const Key& key) {
    const std::size_t at = place_of(key, tag_of(key));
    if (at != kNotFound) remove(table_.slot(at));
  }

  /// Calls visit(key, value) for each entry. Does not count as a use; `visit` must not use this cache.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for (const Slot& slot : slots_) visit(slot.key, slot.value);
  }

  /// Returns at once: call fit() until everything fits.
  void set_capacity(std::size_t capacity_bytes) { capacity_bytes_ = capacity_bytes; }
  /// Evicts the excess and frees its memory. Examines at most `probes` entries and subtracts their number
  /// from `probes`. Returns true if everything fits now.
  [[nodiscard]] bool fit(std::size_t& probes) {
    for (; bytes_ > capacity_bytes_; --probes) {
      if (probes == 0) return false;
      const std::uint32_t index = step();
      if (!std::exchange(slots_[index].used, false)) remove(index);
    }
    shrink_table();
    return true;
  }

  /// Bytes of all entries with their overhead.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t size() const { return slots_.size(); }

 private:
  // Only allocations may throw.
  static_assert(std::is_nothrow_copy_constructible_v<Key> && std::is_nothrow_copy_assignable_v<Key> &&
                std::is_nothrow_move_constructible_v<Value> && std::is_nothrow_move_assignable_v<Value> &&
                std::is_nothrow_default_constructible_v<Value>);

  static std::uint32_t tag_of(const Key& key) { return static_cast<std::uint32_t>(std::hash<Key>{}(key)); }
  [[nodiscard]] std::size_t place_of(const Key& key, std::uint32_t tag) const {
    return table_.find(tag, [&](std::uint32_t slot) { return slots_[slot].key == key; });
  }

  /// Adds a slot and a place for one more entry. The only allocation of put().
  std::uint32_t add_slot(std::uint32_t tag) {
    table_.grow_for(slots_.size() + 1);
    slots_.emplace_back();
    const auto index = static_cast<std::uint32_t>(slots_.size() - 1);
    table_.insert({tag, index});
    return index;
  }

  /// Shrinks a table much larger than its entries need, if there is memory for a smaller one.
  void shrink_table() {
    try {
      table_.shrink_for(slots_.size());
    } catch (const std::bad_alloc&) {
      return;  // retried by the next fit()
    }
  }

  /// Returns the slot under the hand and advances it.
  std::uint32_t step() {
    const std::uint32_t index = hand_;
    hand_ = index + 1 < slots_.size() ? index + 1 : 0;
    return index;
  }
  /// REQUIRES: there is an entry other than `kept`.
  std::uint32_t next_victim(std::uint32_t kept) {
    for (;;) {
      const std::uint32_t index = step();
      if (!std::exchange(slots_[index].used, false) && index != kept) return index;
    }
  }

  /// Moves the last entry into the slot. If that moves it behind the hand, it stays one round longer.
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
  std::deque<Slot> slots_;  // a deque: growing moves no entries
  SlotTable table_;
};

}  // namespace talus::server
