// Materials by how often they occur: a list, and for each an interval of the probability range. FORMAT.md,
// "Materials with probabilities".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/codec.h>
#include <talus/voxel/material.h>

#include "rans.h"
#include "volume_code.h"

namespace talus::codec {

/// The encoder's side: counts materials, then knows their intervals.
class MaterialCode {
 public:
  static constexpr std::size_t kMaxMaterials = kProbabilityTotal;

  /// `first` stands first in the list, whether or not it is counted.
  explicit MaterialCode(MaterialId first) { count(first, 0); }

  /// False where there would be more than kMaxMaterials.
  [[nodiscard]] bool add(MaterialId material) { return count(material, 1); }

  /// When all have been added: gives each its interval and appends list and sizes.
  void finish(std::vector<std::byte>& out);

  [[nodiscard]] Interval interval(MaterialId material) const { return entries_[place_of(material)].interval; }

 private:
  // Open addressing; four places for each material.
  static constexpr std::size_t kPlaces = 4 * kMaxMaterials;
  struct Entry {
    MaterialId material{};
    bool used = false;
    std::uint32_t count = 0;
    Interval interval;
  };

  [[nodiscard]] std::size_t place_of(MaterialId material) const {
    std::size_t place = to_integer(material) * std::size_t{0x9E37} / 8 % kPlaces;
    while (entries_[place].used && entries_[place].material != material) place = (place + 1) % kPlaces;
    return place;
  }

  bool count(MaterialId material, std::uint32_t times) {
    Entry& entry = entries_[place_of(material)];
    if (!entry.used) {
      if (size_ == kMaxMaterials) return false;
      entry = {material, true, 0, {}};
      order_[size_++] = material;
    }
    entry.count += times;
    return true;
  }

  std::array<Entry, kPlaces> entries_{};
  std::array<MaterialId, kMaxMaterials> order_;
  std::size_t size_ = 0;
};

/// Takes list and sizes from the front of `bytes`; gives the first material of the list.
[[nodiscard]] tl::expected<MaterialId, DecodeError> take_material_code(std::span<const std::byte>& bytes,
                                                                       SlotTable& slots);

/// `counts` as sizes of intervals: those that occur have at least 1, and all together kProbabilityTotal.
void to_sizes(std::span<const std::uint32_t> counts, std::span<std::uint16_t> sizes);

}  // namespace talus::codec
