// Maps keys to slots that its user owns: an open-addressing table of eight bytes per place, which stays in
// near CPU caches where list nodes would not. For one thread; its users lock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace talus::server {

class SlotTable {
 public:
  static constexpr std::size_t kNotFound = std::numeric_limits<std::size_t>::max();
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// The tag is the low half of a key's hash; most mismatches are found without reading the slots.
  struct Place {
    std::uint32_t tag = 0;
    std::uint32_t slot = kNone;
  };

  /// Returns the place of a slot with this tag for which is_it(slot) is true.
  template <typename IsIt>
  [[nodiscard]] std::size_t find(std::uint32_t tag, IsIt&& is_it) const {
    if (places_.empty()) return kNotFound;
    for (std::size_t at = home_of(tag); places_[at].slot != kNone; at = after(at)) {
      if (places_[at].tag == tag && is_it(places_[at].slot)) return at;
    }
    return kNotFound;
  }
  /// Returns the place of a slot, which must be in the table.
  [[nodiscard]] std::size_t place_of(std::uint32_t tag, std::uint32_t slot) const {
    std::size_t at = home_of(tag);
    while (places_[at].slot != slot) at = after(at);
    return at;
  }
  [[nodiscard]] std::uint32_t slot(std::size_t place) const { return places_[place].slot; }
  void set_slot(std::size_t place, std::uint32_t slot) noexcept { places_[place].slot = slot; }

  /// Makes room for `slots` slots, at most three quarters full. Throws std::bad_alloc without changing
  /// anything.
  void grow_for(std::size_t slots) {
    if (4 * slots > 3 * places_.size()) resize(places_.empty() ? kMinPlaces : 2 * places_.size());
  }
  /// Shrinks a table much larger than `slots` slots need. Throws like grow_for().
  void shrink_for(std::size_t slots) {
    std::size_t needed = slots == 0 ? 0 : kMinPlaces;
    while (4 * slots > 3 * needed) needed *= 2;
    if (places_.size() > 2 * needed) resize(needed);
  }

  /// REQUIRES: there is room.
  void insert(Place place) noexcept {
    std::size_t at = home_of(place.tag);
    while (places_[at].slot != kNone) at = after(at);
    places_[at] = place;
  }
  /// Moves up entries after it that could no longer be found.
  void erase(std::size_t place) noexcept {
    for (std::size_t at = after(place); places_[at].slot != kNone; at = after(at)) {
      const std::size_t way_from_home = (at - home_of(places_[at].tag)) & (places_.size() - 1);
      const std::size_t way_from_gap = (at - place) & (places_.size() - 1);
      if (way_from_home < way_from_gap) continue;
      places_[place] = places_[at];
      place = at;
    }
    places_[place] = {};
  }

 private:
  static constexpr std::size_t kMinPlaces = 16;

  [[nodiscard]] std::size_t home_of(std::uint32_t tag) const { return tag & (places_.size() - 1); }
  [[nodiscard]] std::size_t after(std::size_t at) const { return (at + 1) & (places_.size() - 1); }
  void resize(std::size_t places) {
    std::vector<Place> before(places);
    before.swap(places_);
    for (const Place place : before) {
      if (place.slot != kNone) insert(place);
    }
  }

  std::vector<Place> places_;  // a power of two of them, or empty
};

}  // namespace talus::server
