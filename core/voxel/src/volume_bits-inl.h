// Prediction of a wave's voxels if all are known, one bit per voxel and property: FORMAT.md, "Volume:
// prediction". A vector holds the bits of up to sixteen rows, the maximum of a wave, so that few instructions
// process all its voxels. volume_near-inl.h does the same with a byte per voxel, for decoders, which know
// only half a wave; volume_model.h works voxel by voxel. Included once per instruction set, hence this guard:
#if defined(TALUS_VOLUME_BITS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_BITS_INL
#undef TALUS_VOLUME_BITS_INL
#else
#define TALUS_VOLUME_BITS_INL
#endif

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <hwy/highway.h>

#include "volume_parts-inl.h"
#include "volume_rows.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

/// Two adjacent rows.
inline constexpr std::size_t kPairBytes = 2 * kRowBytes;
inline constexpr std::size_t kPairParts = kPairBytes / kPartBytes;
struct RowPair {
  PartVec part[kPairParts];
};

HWY_INLINE RowPair load_pair(const std::uint8_t* bytes) {
  RowPair pair;
  for (std::size_t p = 0; p < kPairParts; ++p) pair.part[p] = load(bytes + p * kPartBytes);
  return pair;
}

/// Bit i is set if voxel i of 64 is equal.
HWY_INLINE std::uint64_t equal_bits(const RowPair& a, const RowPair& b) {
  std::uint64_t bits = 0;
  for (std::size_t p = 0; p < kPairParts; ++p)
    bits |= std::uint64_t{bits_of(hn::Eq(a.part[p], b.part[p]))} << (p * kPartBytes);
  return bits;
}

HWY_INLINE std::uint64_t load_bits(const std::uint32_t* words) {
  std::uint64_t bits;
  std::memcpy(&bits, words, sizeof bits);
  return bits;
}
HWY_INLINE void store_bits(std::uint64_t bits, std::uint32_t* words) {
  static_assert(std::endian::native == std::endian::little);  // the first row's word comes first
  std::memcpy(words, &bits, sizeof bits);
}

/// Rows of a wave.
struct WaveSpan {
  explicit WaveSpan(int wave)
      : first{static_cast<std::size_t>(first_row_of(wave))},
        rows{static_cast<std::size_t>(last_row_of(wave)) - first + 1} {}

  [[nodiscard]] std::size_t pairs() const { return (rows + 1) / 2; }
  /// Mask of the voxels of a pair of rows that belong to the wave.
  [[nodiscard]] std::uint64_t inside(std::size_t pair) const {
    return 2 * pair + 1 < rows ? ~std::uint64_t{0} : 0xFFFFFFFFU;
  }

  std::size_t first;  // y
  std::size_t rows;
};

/// Equality bits of the voxels of the last four waves, one word per row from y = -1. Missing voxels count as
/// equal.
class EqualWords {
 public:
  EqualWords() {
    for (auto& wave : words_) wave.fill(~std::uint32_t{0});
  }
  /// The word of row y = 0.
  [[nodiscard]] HWY_INLINE std::uint32_t* of(int wave) {
    return words_[static_cast<std::size_t>(wave + 4) % 4].data() + kBefore;
  }

 private:
  static constexpr std::size_t kBefore = 16;
  alignas(64) std::array<std::array<std::uint32_t, kBefore + kChunkSize + 16>, 4> words_;
};

/// One word of bits per row.
using RowBits = hn::CappedTag<std::uint32_t, kWaveRows>;
using RowVec = hn::Vec<RowBits>;
inline constexpr std::size_t kRowLanes = hn::MaxLanes(RowBits{});

HWY_INLINE RowVec load_rows(const std::uint32_t* words) {
  return hn::LoadU(RowBits{}, words);
}
HWY_INLINE RowVec row_bits(std::uint32_t bits) {
  return hn::Set(RowBits{}, bits);
}
/// Selects each bit from `yes` if its bit in `where` is set, otherwise from `no`.
HWY_INLINE RowVec pick_bits(RowVec where, RowVec yes, RowVec no) {
#if HWY_TARGET == HWY_AVX3
  return RowVec{_mm512_ternarylogic_epi32(where.raw, yes.raw, no.raw, 0xCA)};
#else
  return hn::Or(hn::And(where, yes), hn::AndNot(where, no));
#endif
}
HWY_INLINE RowVec pick_odd(RowVec odd, RowVec even) {
  return pick_bits(row_bits(0xAAAAAAAAU), odd, even);
}

/// Equality of the last four waves' voxels with the voxels below, to the north and to the west.
struct NearEquals {
  EqualWords below;
  EqualWords north;
  EqualWords west;
};

/// Bits of NearEquals for a wave's rows from row y.
struct NearVec {
  HWY_INLINE NearVec(NearEquals& equals, std::size_t y, int wave)
      : equals_below{load_rows(equals.below.of(wave) + y)},
        equals_north{load_rows(equals.north.of(wave) + y)},
        equals_west{load_rows(equals.west.of(wave) + y)},
        upright{load_rows(equals.below.of(wave - 1) + y)},
        level{load_rows(equals.north.of(wave - 2) + y - 1)},
        level_south{load_rows(equals.north.of(wave - 1) + y - 1)},
        north_west{load_rows(equals.west.of(wave - 1) + y)},
        north_east{beside(north_west)},
        below_west{load_rows(equals.west.of(wave - 2) + y - 1)},
        below_east{beside(below_west)} {}

  /// Set if a voxel equals the one to its east. The voxel outside the last column counts as equal.
  static HWY_INLINE RowVec beside(RowVec equals_west) {
    return hn::Or(hn::ShiftRight<1>(equals_west), row_bits(0x80000000U));
  }
  /// Set if all surroundings are 1.
  [[nodiscard]] HWY_INLINE RowVec around() const {
    return hn::And(hn::And(hn::And(upright, level_south), hn::And(north_west, north_east)),
                   hn::And(below_west, below_east));
  }

  RowVec equals_below, equals_north, equals_west;
  RowVec upright, level, level_south;
  RowVec north_west, north_east, below_west, below_east;  // for the voxels to the north and below
};

/// Further equalities around the voxels of a wave, beyond EqualWords. Names: north_west is set if the voxel
/// to the north equals the one to the west, and so on; south_below and below_north are the voxels south and
/// north of the one below.
struct WaveEquals {
  alignas(64) RowWords north_below;
  alignas(64) RowWords north_south_below;
  alignas(64) RowWords west_east;
  alignas(64) RowWords north_west;
  alignas(64) RowWords north_east;
  alignas(64) RowWords below_west;
  alignas(64) RowWords below_east;
  // The voxel itself against possible second candidates, used if all nearer ones are alike.
  alignas(64) RowWords now_below_north;
  alignas(64) RowWords now_south_below;
};

/// Selects the candidates of a wave's voxels.
struct WaveChoice {
  alignas(64) RowWords level;
  alignas(64) RowWords is_east;
  alignas(64) RowWords equal;
  alignas(64) RowWords base_west;
  alignas(64) RowWords alike;
};

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
