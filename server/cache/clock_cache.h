// A map bounded in bytes that forgets what nobody used of late: a hand goes round the entries and drops the
// first that was not used since it last came by (the CLOCK policy). So a use only sets a flag where the entry
// lies anyway, while a list in order of use would touch three more places in memory. For one thread; its
// users lock.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace talus::server {

template <typename Key, typename Value>
class ClockCache {
  struct Slot {
    Key key{};
    Value value{};
    std::size_t cost = 0;  // 0: vacant
    bool used = false;
  };
  /// Where a key is found: the low half of its hash, so that most others are told apart without their slots.
  struct Place {
    std::uint32_t tag = 0;
    std::uint32_t slot = kVacant;
  };
  static constexpr std::uint32_t kVacant = std::numeric_limits<std::uint32_t>::max();

 public:
  /// What an entry costs beside the bytes of its value: its slot, and places in a table up to three quarters
  /// full.
  static constexpr std::size_t kEntryOverheadBytes = sizeof(Slot) + 2 * sizeof(Place);

  explicit ClockCache(std::size_t capacity_bytes) : capacity_bytes_{capacity_bytes} {}

  /// The value; null where there is none. Valid until the next put(). A use.
  [[nodiscard]] const Value* find(const Key& key) {
    const std::size_t at = place_of(key);
    if (at == kNowhere) return nullptr;
    Slot& slot = slots_[places_[at].slot];
    slot.used = true;
    return &slot.value;
  }

  /// Not a use.
  [[nodiscard]] bool holds(const Key& key) const { return place_of(key) != kNowhere; }

  /// Keeps `value`, which costs `value_bytes`, in the place of what the key had. What is larger than the
  /// whole capacity is not kept.
  void put(const Key& key, Value value, std::size_t value_bytes) {
    if (const std::size_t at = place_of(key); at != kNowhere) drop(at);
    const std::size_t cost = value_bytes + kEntryOverheadBytes;
    if (cost > capacity_bytes_) return;
    shrink_to(capacity_bytes_ - cost);
    std::uint32_t slot = static_cast<std::uint32_t>(slots_.size());
    if (vacant_.empty()) {
      slots_.emplace_back();
    } else {
      slot = vacant_.back();
      vacant_.pop_back();
    }
    slots_[slot] = {key, std::move(value), cost, false};
    bytes_ += cost;
    ++size_;
    if (4 * size_ > 3 * places_.size()) grow();
    settle({tag_of(key), slot});
  }

  /// Forgets at once what is too much.
  void set_capacity(std::size_t capacity_bytes) {
    capacity_bytes_ = capacity_bytes;
    shrink_to(capacity_bytes);
    if (vacant_.size() > slots_.size() / 2) pack();
  }

  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  static constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t kLeastPlaces = 16;

  static std::uint32_t tag_of(const Key& key) { return static_cast<std::uint32_t>(std::hash<Key>{}(key)); }
  [[nodiscard]] std::size_t home_of(Place place) const { return place.tag & (places_.size() - 1); }
  [[nodiscard]] std::size_t after(std::size_t at) const { return (at + 1) & (places_.size() - 1); }

  [[nodiscard]] std::size_t place_of(const Key& key) const {
    if (places_.empty()) return kNowhere;
    const std::uint32_t tag = tag_of(key);
    for (std::size_t at = home_of({tag, 0}); places_[at].slot != kVacant; at = after(at)) {
      if (places_[at].tag == tag && slots_[places_[at].slot].key == key) return at;
    }
    return kNowhere;
  }

  void settle(Place place) {
    std::size_t at = home_of(place);
    while (places_[at].slot != kVacant) at = after(at);
    places_[at] = place;
  }

  void grow() {
    std::vector<Place> before(std::max(kLeastPlaces, 2 * places_.size()));
    before.swap(places_);
    for (const Place place : before) {
      if (place.slot != kVacant) settle(place);
    }
  }

  void shrink_to(std::size_t bytes) {
    while (bytes_ > bytes) {
      Slot& slot = slots_[hand_];
      if (slot.cost > 0 && !slot.used) drop(place_of(slot.key));
      slot.used = false;
      hand_ = (hand_ + 1) % slots_.size();
    }
  }

  /// Gives back the memory of vacant slots.
  void pack() {
    std::deque<Slot> before = std::exchange(slots_, {});
    vacant_ = {};
    places_ = {};
    hand_ = 0;
    for (Slot& slot : before) {
      if (slot.cost > 0) slots_.push_back(std::move(slot));
    }
    while (4 * slots_.size() > 3 * places_.size()) grow();
    for (std::uint32_t slot = 0; slot < slots_.size(); ++slot) settle({tag_of(slots_[slot].key), slot});
  }

  void drop(std::size_t at) {
    const std::uint32_t index = places_[at].slot;
    Slot& slot = slots_[index];
    bytes_ -= slot.cost;
    --size_;
    slot = {};
    vacant_.push_back(index);
    close_gap(at);
  }

  /// What stands behind the gap and could be found no more moves up.
  void close_gap(std::size_t gap) {
    for (std::size_t at = after(gap); places_[at].slot != kVacant; at = after(at)) {
      const std::size_t way_from_home = (at - home_of(places_[at])) & (places_.size() - 1);
      const std::size_t way_from_gap = (at - gap) & (places_.size() - 1);
      if (way_from_home < way_from_gap) continue;
      places_[gap] = places_[at];
      gap = at;
    }
    places_[gap] = {};
  }

  std::size_t capacity_bytes_;
  std::size_t bytes_ = 0;
  std::size_t size_ = 0;
  std::size_t hand_ = 0;
  std::deque<Slot> slots_;  // a deque, so that growing moves nothing
  std::vector<std::uint32_t> vacant_;
  std::vector<Place> places_;  // a power of two of them, or none
};

}  // namespace talus::server
