// Materials and their frequencies: a list with an interval of the probability range for each. FORMAT.md,
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

/// Encoder side: numbers materials in order of appearance, counts them, then assigns their intervals.
class MaterialCode {
 public:
  static constexpr std::size_t kMaxMaterials = kProbabilityTotal;

  /// `first` gets number 0 and is first in the list, even if it is never counted.
  explicit MaterialCode(MaterialId first) { (void)number_of(first); }

  /// Returns the number of a material; kMaxMaterials if the list is full.
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

  /// Call after counting: assigns the intervals and appends list and sizes.
  void finish(std::vector<std::byte>& out);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] MaterialId material(std::size_t number) const { return materials_[number]; }

  /// start + 65536 * size
  [[nodiscard]] std::uint32_t interval(std::uint32_t number) const { return intervals_[number]; }

 private:
  // Open addressing, with enough places that collisions are rare.
  static constexpr std::size_t kPlaces = 4 * kMaxMaterials;

  std::array<std::uint16_t, kPlaces> numbers_{};  // number + 1; 0 if the place is free
  std::array<MaterialId, kMaxMaterials> materials_;
  std::array<std::uint32_t, kMaxMaterials> counts_{};
  std::array<std::uint32_t, kMaxMaterials> intervals_;
  std::uint16_t size_ = 0;
};

/// Removes list and sizes from the front of `bytes`; returns the first material of the list.
[[nodiscard]] tl::expected<MaterialId, DecodeError> take_material_code(std::span<const std::byte>& bytes,
                                                                       SlotTable& slots);

/// Converts `counts` to interval sizes: at least 1 for each nonzero count, kProbabilityTotal in total.
void to_sizes(std::span<const std::uint32_t> counts, std::span<std::uint16_t> sizes);

}  // namespace talus::codec
