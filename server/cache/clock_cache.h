// A map bounded in bytes that evicts by CLOCK (second chance): a hand goes round the entries and evicts the
// first that was not used since it last came by. So a use only sets a flag where the entry lies anyway, while
// a list in order of use would touch three more places in memory. For one thread; its users lock.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace talus::server {

template <typename Key, typename Value>
class ClockCache {
  static constexpr std::uint32_t kVacant = std::numeric_limits<std::uint32_t>::max();
  struct Slot {
    Key key{};
    Value value{};
    std::size_t cost = 0;  // 0: vacant
    std::uint32_t next_vacant = kVacant;
    bool used = false;
  };
  /// Where a key is found. The tag is the low half of its hash, so that most others are told apart without
  /// their slots.
  struct Bucket {
    std::uint32_t tag = 0;
    std::uint32_t slot = kVacant;
  };

 public:
  /// What an entry costs beside the bytes of its value: its slot, and buckets of a table up to three quarters
  /// full.
  static constexpr std::size_t kEntryOverheadBytes = sizeof(Slot) + 2 * sizeof(Bucket);

  explicit ClockCache(std::size_t capacity_bytes) : capacity_bytes_{capacity_bytes} {}

  /// The value; null where there is none. Valid until the next change. A use.
  [[nodiscard]] const Value* find(const Key& key) { return find(key, std::hash<Key>{}(key)); }
  /// For who knows the key's hash already.
  [[nodiscard]] const Value* find(const Key& key, std::size_t hash) {
    const std::size_t at = bucket_of(key, static_cast<std::uint32_t>(hash));
    if (at == kNotFound) return nullptr;
    Slot& slot = slots_[buckets_[at].slot];
    // A write where it is set already would take the cache line from every other core that reads it.
    if (!slot.used) slot.used = true;
    return &slot.value;
  }

  /// Not a use.
  [[nodiscard]] bool holds(const Key& key) const { return bucket_of(key) != kNotFound; }

  /// Keeps `value`, which costs `value_bytes`, in place of what the key had. A value that is larger than the
  /// whole capacity is not kept. Calls evicted(key, value) for each entry that is evicted for it, which must
  /// not throw and not use this cache; at most size() times, and not for what the key had. Throws
  /// std::bad_alloc, and then has changed nothing.
  template <typename Evicted>
  requires std::is_nothrow_invocable_v<Evicted&, const Key&, Value&&>
  void put(const Key& key, Value value, std::size_t value_bytes, Evicted&& evicted) {
    const std::size_t cost = value_bytes + kEntryOverheadBytes;
    // An entry in place of another, replaced or evicted, needs no slot or bucket beside that one's.
    const std::size_t before = bucket_of(key);
    if (before != kNotFound) {
      drop(before);
    } else if (bytes_ + cost <= capacity_bytes_) {
      reserve_slot();
    }
    if (cost > capacity_bytes_) return;
    shrink_to(capacity_bytes_ - cost, evicted);
    const std::uint32_t slot = first_vacant_;
    first_vacant_ = slots_[slot].next_vacant;
    slots_[slot] = {key, std::move(value), cost, kVacant, false};
    bytes_ += cost;
    ++size_;
    insert({tag_of(key), slot});
  }
  void put(const Key& key, Value value, std::size_t value_bytes) {
    put(key, std::move(value), value_bytes, kForget);
  }

  /// No effect where there is none.
  void erase(const Key& key) {
    if (const std::size_t at = bucket_of(key); at != kNotFound) drop(at);
  }

  /// Evicts at once what is too much.
  void set_capacity(std::size_t capacity_bytes) {
    capacity_bytes_ = capacity_bytes;
    shrink_to(capacity_bytes, kForget);
    if (size_ < (slots_.size() + 1) / 2) pack();
  }

  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  static constexpr std::size_t kNotFound = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t kMinBuckets = 16;
  static constexpr auto kForget = [](const Key&, Value&&) noexcept {};
  // So that nothing but an allocation can throw.
  static_assert(std::is_nothrow_copy_assignable_v<Key> && std::is_nothrow_move_assignable_v<Value> &&
                std::is_nothrow_default_constructible_v<Value>);

  static std::uint32_t tag_of(const Key& key) { return static_cast<std::uint32_t>(std::hash<Key>{}(key)); }
  [[nodiscard]] std::size_t home_of(Bucket bucket) const { return bucket.tag & (buckets_.size() - 1); }
  [[nodiscard]] std::size_t after(std::size_t at) const { return (at + 1) & (buckets_.size() - 1); }

  [[nodiscard]] std::size_t bucket_of(const Key& key) const { return bucket_of(key, tag_of(key)); }
  [[nodiscard]] std::size_t bucket_of(const Key& key, std::uint32_t tag) const {
    if (buckets_.empty()) return kNotFound;
    for (std::size_t at = home_of({tag, 0}); buckets_[at].slot != kVacant; at = after(at)) {
      if (buckets_[at].tag == tag && slots_[buckets_[at].slot].key == key) return at;
    }
    return kNotFound;
  }

  void insert(Bucket bucket) noexcept {
    std::size_t at = home_of(bucket);
    while (buckets_[at].slot != kVacant) at = after(at);
    buckets_[at] = bucket;
  }

  /// Makes sure of a bucket and a vacant slot for one entry more. All that put() allocates.
  void reserve_slot() {
    if (4 * (size_ + 1) > 3 * buckets_.size()) grow();
    if (first_vacant_ != kVacant) return;
    slots_.emplace_back();
    first_vacant_ = static_cast<std::uint32_t>(slots_.size() - 1);
  }

  void grow() {
    std::vector<Bucket> before(std::max(kMinBuckets, 2 * buckets_.size()));
    before.swap(buckets_);
    for (const Bucket bucket : before) {
      if (bucket.slot != kVacant) insert(bucket);
    }
  }

  template <typename Evicted>
  void shrink_to(std::size_t bytes, Evicted&& evicted) {
    while (bytes_ > bytes) {
      Slot& slot = slots_[hand_];
      hand_ = (hand_ + 1) % slots_.size();
      if (slot.cost > 0 && !slot.used) {
        const Key key = slot.key;
        evicted(key, drop(bucket_of(key)));
      }
      slot.used = false;
    }
  }

  /// Gives back the memory of vacant slots, where there is memory to pack the others in.
  void pack() {
    std::size_t fewer = size_ == 0 ? 0 : kMinBuckets;
    while (4 * size_ > 3 * fewer) fewer *= 2;
    try {
      std::vector<Bucket> buckets(fewer);
      std::deque<Slot> slots(size_);
      auto next = slots.begin();  // from here on nothing throws
      for (Slot& slot : slots_) {
        if (slot.cost > 0) *next++ = std::move(slot);
      }
      slots_.swap(slots);
      buckets_.swap(buckets);
    } catch (const std::bad_alloc&) {
      return;  // the next set_capacity() tries again
    }
    first_vacant_ = kVacant;
    hand_ = 0;
    for (std::uint32_t slot = 0; slot < slots_.size(); ++slot) insert({tag_of(slots_[slot].key), slot});
  }

  Value drop(std::size_t at) noexcept {
    const std::uint32_t index = buckets_[at].slot;
    Slot& slot = slots_[index];
    bytes_ -= slot.cost;
    --size_;
    Value value = std::move(slot.value);
    slot = {};
    slot.next_vacant = std::exchange(first_vacant_, index);
    close_gap(at);
    return value;
  }

  /// What stands behind the gap and could not be found any more moves up.
  void close_gap(std::size_t gap) {
    for (std::size_t at = after(gap); buckets_[at].slot != kVacant; at = after(at)) {
      const std::size_t way_from_home = (at - home_of(buckets_[at])) & (buckets_.size() - 1);
      const std::size_t way_from_gap = (at - gap) & (buckets_.size() - 1);
      if (way_from_home < way_from_gap) continue;
      buckets_[gap] = buckets_[at];
      gap = at;
    }
    buckets_[gap] = {};
  }

  std::size_t capacity_bytes_;
  std::size_t bytes_ = 0;
  std::size_t size_ = 0;
  std::size_t hand_ = 0;
  std::deque<Slot> slots_;  // a deque, so that growing moves nothing
  std::uint32_t first_vacant_ = kVacant;
  std::vector<Bucket> buckets_;  // a power of two of them, or none
};

}  // namespace talus::server
