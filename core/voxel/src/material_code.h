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

/// The encoder's side: numbers materials as they come and counts them, then knows their intervals.
class MaterialCode {
 public:
  static constexpr std::size_t kMaxMaterials = kProbabilityTotal;

  /// `first` is number 0 and stands first in the list, whether or not it is counted.
  explicit MaterialCode(MaterialId first) { (void)number_of(first); }

  /// The number of a material; kMaxMaterials where there would be more than that.
  [[nodiscard]] std::uint32_t number_of(MaterialId material) {
    std::size_t place = to_integer(material) % kPlaces;
    while (numbers_[place] != 0 && materials_[numbers_[place] - 1U] != material)
      place = (place + 1) % kPlaces;
    if (numbers_[place] == 0) {
      if (size_ == kMaxMaterials) return kMaxMaterials;
      materials_[size_++] = material;
      numbers_[place] = size_;
    }
    return numbers_[place] - 1U;
  }

  void count(std::uint32_t number, std::uint32_t times = 1) { counts_[number] += times; }

  /// When all have been counted: gives each its interval and appends list and sizes.
  void finish(std::vector<std::byte>& out);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] MaterialId material(std::size_t number) const { return materials_[number]; }

  /// Start + 65536 * size.
  [[nodiscard]] std::uint32_t interval(std::uint32_t number) const { return intervals_[number]; }

 private:
  // Open addressing; places are enough that few materials meet.
  static constexpr std::size_t kPlaces = 4 * kMaxMaterials;

  std::array<std::uint16_t, kPlaces> numbers_{};  // one more than the number; 0 where a place is free
  std::array<MaterialId, kMaxMaterials> materials_;
  std::array<std::uint32_t, kMaxMaterials> counts_{};
  std::array<std::uint32_t, kMaxMaterials> intervals_;
  std::uint16_t size_ = 0;
};

/// Takes list and sizes from the front of `bytes`; gives the first material of the list.
[[nodiscard]] tl::expected<MaterialId, DecodeError> take_material_code(std::span<const std::byte>& bytes,
                                                                       SlotTable& slots);

/// `counts` as sizes of intervals: those that occur have at least 1, and all together kProbabilityTotal.
void to_sizes(std::span<const std::uint32_t> counts, std::span<std::uint16_t> sizes);

}  // namespace talus::codec
