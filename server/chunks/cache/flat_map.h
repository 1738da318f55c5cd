// A map of many small values for lookups that mostly miss the CPU caches: a lookup costs about one cache
// miss; a std::unordered_map costs three. For one thread; its users lock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <type_traits>
#include <utility>

#include "chunks/cache/slot_table.h"

namespace talus::server {

template <typename Key, typename Value>
class FlatMap {
 public:
  [[nodiscard]] std::size_t size() const { return slots_.size(); }
  [[nodiscard]] bool empty() const { return slots_.empty(); }

  /// Null if not found. Valid until an entry is erased.
  [[nodiscard]] const Value* find(const Key& key) const {
    const std::size_t place = place_of(key);
    return place == SlotTable::kNotFound ? nullptr : &slots_[table_.slot(place)].second;
  }
  [[nodiscard]] Value* find(const Key& key) { return const_cast<Value*>(std::as_const(*this).find(key)); }

  /// Returns the key's value and true if it was created now. Throws std::bad_alloc without changing anything.
  std::pair<Value&, bool> emplace(const Key& key) {
    const std::size_t place = place_of(key);
    if (place != SlotTable::kNotFound) return {slots_[table_.slot(place)].second, false};
    table_.grow_for(slots_.size() + 1);
    slots_.emplace_back(key, Value{});
    table_.insert({tag_of(key), static_cast<std::uint32_t>(slots_.size() - 1)});
    return {slots_.back().second, true};
  }
  Value& operator[](const Key& key) { return emplace(key).first; }

  /// Returns true if the key was present. The last value moves into its place.
  bool erase(const Key& key) noexcept {
    static_assert(std::is_nothrow_move_assignable_v<Value>);
    const std::size_t place = place_of(key);
    if (place == SlotTable::kNotFound) return false;
    const std::uint32_t slot = table_.slot(place);
    const auto last = static_cast<std::uint32_t>(slots_.size() - 1);
    table_.erase(place);
    if (slot != last) {
      table_.set_slot(table_.place_of(tag_of(slots_[last].first), last), slot);
      slots_[slot] = std::move(slots_[last]);
    }
    slots_.pop_back();
    return true;
  }

  /// In unspecified order.
  [[nodiscard]] auto begin() const { return slots_.begin(); }
  [[nodiscard]] auto end() const { return slots_.end(); }

 private:
  static std::uint32_t tag_of(const Key& key) { return static_cast<std::uint32_t>(std::hash<Key>{}(key)); }
  [[nodiscard]] std::size_t place_of(const Key& key) const {
    return table_.find(tag_of(key), [&](std::uint32_t slot) { return slots_[slot].first == key; });
  }

  std::deque<std::pair<Key, Value>> slots_;  // a deque: growing moves no entries
  SlotTable table_;
};

}  // namespace talus::server
