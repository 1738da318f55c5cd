// A map bounded in bytes that forgets what was not used for longest. For one thread; its users lock.
#pragma once

#include <cstddef>
#include <list>
#include <unordered_map>
#include <utility>

namespace talus::server {

template <typename Key, typename Value>
class Lru {
 public:
  /// What an entry costs beside the bytes of its value: its list node, its map node with a bucket, and
  /// what the allocator adds to each.
  static constexpr std::size_t kEntryOverheadBytes =
      sizeof(std::pair<Key, Value>) + sizeof(Key) + 10 * sizeof(void*) + 32;

  explicit Lru(std::size_t capacity_bytes) : capacity_bytes_{capacity_bytes} {}

  /// The value, now the most recently used; null where there is none. Valid until the next put().
  [[nodiscard]] const Value* find(const Key& key) {
    const auto found = by_key_.find(key);
    if (found == by_key_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found->second);
    return &found->second->value;
  }

  /// Keeps `value`, which costs `value_bytes`, in the place of what the key had. What is larger than the
  /// whole capacity is not kept.
  void put(const Key& key, Value value, std::size_t value_bytes) {
    put(key, std::move(value), value_bytes, [](const Key&, Value&&) {});
  }
  /// The same; calls dropped(key, value) for each entry that had to make room.
  template <typename Dropped>
  void put(const Key& key, Value value, std::size_t value_bytes, Dropped&& dropped) {
    erase(key);
    const std::size_t cost = value_bytes + kEntryOverheadBytes;
    if (cost > capacity_bytes_) return;
    shrink_to(capacity_bytes_ - cost, dropped);
    entries_.push_front({key, std::move(value), cost});
    by_key_.emplace(key, entries_.begin());
    bytes_ += cost;
  }

  /// Forgets at once what is too much.
  void set_capacity(std::size_t capacity_bytes) {
    capacity_bytes_ = capacity_bytes;
    shrink_to(capacity_bytes, [](const Key&, Value&&) {});
  }

  void erase(const Key& key) {
    const auto found = by_key_.find(key);
    if (found == by_key_.end()) return;
    bytes_ -= found->second->cost;
    entries_.erase(found->second);
    by_key_.erase(found);
  }
  /// Not a use.
  [[nodiscard]] bool holds(const Key& key) const { return by_key_.contains(key); }

  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    Key key;
    Value value;
    std::size_t cost;
  };

  template <typename Dropped>
  void shrink_to(std::size_t bytes, Dropped&& dropped) {
    while (bytes_ > bytes) {
      Entry& last = entries_.back();
      by_key_.erase(last.key);
      bytes_ -= last.cost;
      dropped(last.key, std::move(last.value));
      entries_.pop_back();
    }
  }

  std::size_t capacity_bytes_;
  std::size_t bytes_ = 0;
  std::list<Entry> entries_;  // most recently used first
  std::unordered_map<Key, typename std::list<Entry>::iterator> by_key_;
};

}  // namespace talus::server
