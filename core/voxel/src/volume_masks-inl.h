// What is known of rows of voxels before they are coded, as masks: bit x is of the voxel at x. FORMAT.md,
// "Volume", has the same voxel by voxel, and so has volume_model.h.
// Included once for each instruction set, hence no include guard but this:
#if defined(TALUS_VOLUME_MASKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_MASKS_INL
#undef TALUS_VOLUME_MASKS_INL
#else
#define TALUS_VOLUME_MASKS_INL
#endif

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>
#include <talus/voxel/coords.h>

HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

using RowMask = std::uint32_t;
inline constexpr RowMask kAllColumns = 0xFFFFFFFF;
inline constexpr RowMask kEvenColumns = 0x55555555;
inline constexpr RowMask kOddColumns = 0xAAAAAAAA;

/// Masks of one row, or of as many rows as a vector of masks has: whatever has &, | and ~.
template <class Mask>
[[nodiscard]] HWY_INLINE Mask select(const Mask& where, const Mask& yes, const Mask& no) {
  return (yes & where) | (no & ~where);
}

/// Which neighbours of a row's voxels are equal.
template <class Mask>
struct AroundMasks {
  Mask upright;      // to the north: the row and the one below it
  Mask level;        // below: the row and the one to its north
  Mask level_south;  // below: the row and the one to its south
  Mask west_n;       // in the row to the north: a voxel and the one to its west
  Mask east_n;
  Mask west_b;  // in the row below
  Mask east_b;

  [[nodiscard]] HWY_INLINE Mask all() const {
    return upright & level_south & west_n & east_n & west_b & east_b;
  }
};

/// The bits of contexts, by voxel.
template <class Mask>
using ContextBits = std::array<Mask, 8>;

/// Of even columns: `same` where north and below are equal, `south` where those of below_south and north are.
template <class Mask>
[[nodiscard]] HWY_INLINE ContextBits<Mask> even_contexts(const AroundMasks<Mask>& a, const Mask& same,
                                                         const Mask& south) {
  return {select(same, a.upright, a.level),
          select(same, a.level_south, a.upright),
          select(same, a.west_n, a.level_south),
          select(same, a.east_n, south),
          select(same, a.west_b, a.west_n & a.east_n),
          select(same, a.east_b, a.west_b & a.east_b),
          ~same,
          ~same};
}

/// How the west and the east of odd columns stand to their base and other candidate.
template <class Mask>
struct BesideMasks {
  Mask equal;  // west and east are equal
  Mask base_west;
  Mask base_east;
  Mask other_west;
  Mask other_east;

  [[nodiscard]] HWY_INLINE Mask agrees() const { return equal & base_west & other_west; }
  /// Where the east is the first candidate.
  [[nodiscard]] HWY_INLINE Mask is_east() const { return ~equal & (base_east | (~base_west & other_east)); }
};

template <class Mask>
[[nodiscard]] HWY_INLINE ContextBits<Mask> odd_contexts(const AroundMasks<Mask>& a,
                                                        const BesideMasks<Mask>& b, const Mask& same) {
  const Mask agrees = b.agrees();
  const Mask is_east = b.is_east();
  const auto bit = [&](const Mask& where_agree, const Mask& where_equal, const Mask& where_differ) HWY_ATTR {
    return select(agrees, where_agree, select(b.equal, where_equal, where_differ));
  };
  return {bit(a.upright, b.base_west, select(is_east, b.base_east, b.base_west)),
          bit(a.level_south, b.other_west, select(is_east, b.other_east, b.other_west)),
          bit(a.west_n, same, select(is_east, b.base_west, b.base_east)),
          bit(a.east_n, a.upright, select(is_east, b.other_west, b.other_east)),
          bit(a.west_b, a.level, a.upright),
          bit(a.east_b, a.level_south, a.level),
          ~agrees & (b.equal | a.level_south),
          ~b.equal};
}

/// Byte i is bit i.
inline constexpr auto kBitsAsBytes = [] {
  std::array<std::uint64_t, 256> table{};
  for (std::uint64_t byte = 0; byte < 256; ++byte) {
    for (std::uint64_t bit = 0; bit < 8; ++bit) table[byte] |= (byte >> bit & 1U) << (8 * bit);
  }
  return table;
}();

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
