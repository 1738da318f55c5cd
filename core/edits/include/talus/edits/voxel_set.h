// A set of voxels of one chunk, with the rank of each: what lets an edit keep its voxels in an array as long
// as it has voxels, and find any of them at once.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <talus/voxel/coords.h>

namespace talus::edits {

/// One bit for each voxel_index(); a word is a row (y, z). 4 KiB, and 2 KiB for the ranks.
class VoxelSet {
 public:
  void insert(std::uint16_t index) { rows_[index / kChunkSize] |= bit(index); }
  [[nodiscard]] bool contains(std::uint16_t index) const {
    return (rows_[index / kChunkSize] & bit(index)) != 0;
  }

  /// Counts the voxels before each row. To be called after the last insert(), before size() and rank().
  void count();
  [[nodiscard]] std::size_t size() const { return size_; }
  /// How many voxels of the set have a lower index.
  [[nodiscard]] std::size_t rank(std::uint16_t index) const {
    const std::size_t row = index / kChunkSize;
    return before_[row] + static_cast<std::size_t>(std::popcount(rows_[row] & (bit(index) - 1)));
  }

  /// Calls visit(index) for each voxel, by rising index.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (std::uint32_t left = rows_[row]; left != 0; left &= left - 1) {
        visit(
            static_cast<std::uint16_t>(row * kChunkSize + static_cast<std::size_t>(std::countr_zero(left))));
      }
    }
  }

 private:
  static_assert(kChunkSize == 32, "a row of voxels is one word");
  static constexpr std::uint32_t bit(std::uint16_t index) { return std::uint32_t{1} << (index % kChunkSize); }

  std::array<std::uint32_t, kChunkArea> rows_{};
  std::array<std::uint16_t, kChunkArea> before_{};
  std::size_t size_ = 0;
};

}  // namespace talus::edits
