// What is known of a row of voxels before it is coded, as masks: bit x is of the voxel at x. FORMAT.md,
// "Volume", has the same voxel by voxel, and so has volume_model.h.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <talus/voxel/coords.h>

namespace talus::codec {

using RowMask = std::uint32_t;
inline constexpr RowMask kAllColumns = 0xFFFFFFFF;
inline constexpr RowMask kEvenColumns = 0x55555555;
inline constexpr RowMask kOddColumns = 0xAAAAAAAA;

[[nodiscard]] constexpr RowMask select(RowMask where, RowMask yes, RowMask no) {
  return (yes & where) | (no & ~where);
}

/// Which neighbours of a row's voxels are equal.
struct AroundMasks {
  RowMask upright;      // to the north: the row and the one below it
  RowMask level;        // below: the row and the one to its north
  RowMask level_south;  // below: the row and the one to its south
  RowMask west_n;       // in the row to the north: a voxel and the one to its west
  RowMask east_n;
  RowMask west_b;  // in the row below
  RowMask east_b;

  [[nodiscard]] RowMask all() const {
    return upright & level_south & west_n & east_n & west_b & east_b;
  }
};

/// By row: which voxels equal a neighbour. A border stands for rows that are not there, so that each row finds
/// what rows_around() of volume_model.h says.
class EqualMasks {
 public:
  EqualMasks() { std::memset(this, 0xFF, sizeof *this); }

  [[nodiscard]] AroundMasks around(std::size_t y, std::size_t z) const {
    const std::size_t at = place(y, z);
    const RowMask west_n = west_[at - 1];
    const RowMask west_b = west_[at - kEdge];
    return {below_[at - 1],
            north_[at - kEdge],
            north_[at - kEdge + 1],
            west_n,
            west_n >> 1U | 1U << 31U,
            west_b,
            west_b >> 1U | 1U << 31U};
  }

  /// `west`, `north`, `below`: where the voxels of row (y, z) equal those there.
  void set(std::size_t y, std::size_t z, RowMask west, RowMask north, RowMask below) {
    const std::size_t at = place(y, z);
    west_[at] = west | 1U;
    if (z != 0) north_[at] = north;
    if (y != 0) below_[at] = below;
    if (z == 0) west_[at + kEdge - 1] = west | 1U;
    if (y == 0) west_[at - kEdge + 1] = west | 1U;
  }

 private:
  static constexpr std::size_t kEdge = kChunkSize + 2;
  static constexpr std::size_t place(std::size_t y, std::size_t z) { return (y + 1) * kEdge + z + 1; }
  using Masks = std::array<RowMask, (kChunkSize + 2) * kEdge>;
  Masks west_;
  Masks north_;
  Masks below_;
};

/// The bits of contexts, by voxel.
using ContextBits = std::array<RowMask, 8>;

/// Of even columns: `same` where north and below are equal, `south` where those of below_south and north are.
[[nodiscard]] inline ContextBits even_contexts(const AroundMasks& a, RowMask same, RowMask south) {
  return {select(same, a.upright, a.level),
          select(same, a.level_south, a.upright),
          select(same, a.west_n, a.level_south),
          select(same, a.east_n, south),
          select(same, a.west_b, a.west_n & a.east_n),
          select(same, a.east_b, a.west_b & a.east_b),
          ~same,
          0};
}

/// How the west and the east of odd columns stand to their base and other candidate.
struct BesideMasks {
  RowMask equal;  // west and east are equal
  RowMask base_west;
  RowMask base_east;
  RowMask other_west;
  RowMask other_east;

  [[nodiscard]] RowMask agrees() const { return equal & base_west & other_west; }
  /// Where the east is the first candidate.
  [[nodiscard]] RowMask is_east() const { return ~equal & (base_east | (~base_west & other_east)); }
};

[[nodiscard]] inline ContextBits odd_contexts(const AroundMasks& a, const BesideMasks& b, RowMask same) {
  const RowMask agrees = b.agrees();
  const RowMask differ = ~b.equal;
  const RowMask is_east = b.is_east();
  const auto bit = [&](RowMask where_agree, RowMask where_equal, RowMask where_differ) {
    return select(agrees, where_agree, select(differ, where_differ, where_equal));
  };
  return {bit(a.upright, b.base_west, select(is_east, b.base_east, b.base_west)),
          bit(a.level_south, b.other_west, select(is_east, b.other_east, b.other_west)),
          bit(a.west_n, same, select(is_east, b.base_west, b.base_east)),
          bit(a.east_n, a.upright, select(is_east, b.other_west, b.other_east)),
          bit(a.west_b, a.level, a.upright),
          bit(a.east_b, a.level_south, a.level),
          bit(0, kAllColumns, a.level_south),
          differ};
}

/// Byte i is bit i.
inline constexpr auto kBitsAsBytes = [] {
  std::array<std::uint64_t, 256> table{};
  for (std::uint64_t byte = 0; byte < 256; ++byte) {
    for (std::uint64_t bit = 0; bit < 8; ++bit) table[byte] |= (byte >> bit & 1U) << (8 * bit);
  }
  return table;
}();

}  // namespace talus::codec
