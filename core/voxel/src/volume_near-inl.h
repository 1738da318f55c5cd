// Prediction of the voxels of a part: FORMAT.md, "Volume: prediction". volume_model.h does the same voxel by
// voxel.
// Included once per instruction set, hence this guard:
#if defined(TALUS_VOLUME_NEAR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_NEAR_INL
#undef TALUS_VOLUME_NEAR_INL
#else
#define TALUS_VOLUME_NEAR_INL
#endif

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "volume_parts-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

// Equalities of a voxel as bits of a byte: with the voxel below, and so on. West and east occur twice, once
// for the north's part of a context and once for the part of the voxel below.
inline constexpr std::uint8_t kEqualsBelow = 1;
inline constexpr std::uint8_t kEqualsNorth = 2;
inline constexpr std::uint8_t kEqualsWest = 4 + 16;
inline constexpr std::uint8_t kEqualsEast = 8 + 32;
inline constexpr std::uint8_t kEqualsAll = 63;

/// A table of sixteen bytes, repeated in each block of a vector.
using ByteTable = std::array<std::uint8_t, 16>;
/// Returns the entries at the lowest four bits of the index, whose highest bit is 0.
HWY_INLINE PartVec look_up(const ByteTable& table, PartVec index) {
#if !HWY_ARCH_X86  // where an index over 15 finds 0
  index = hn::And(index, bytes_of(15));
#endif
  return hn::TableLookupBytes(hn::LoadDup128(Part{}, table.data()), index);
}
template <class Value>
constexpr ByteTable table_of(const Value& value) {
  ByteTable table{};
  for (unsigned i = 0; i < table.size(); ++i) table[i] = static_cast<std::uint8_t>(value(i));
  return table;
}

// Context if north and below differ, as a byte: level, upright, level south, south, west and east of north,
// of below, and 64 = 1. The tables give the parts that follow from the bits above, of three rows; they are
// indexed by the lowest four bits.
constexpr unsigned has_both(unsigned equal) {
  return (equal & 12U) == 12 ? 1 : 0;
}
alignas(16) inline constexpr ByteTable kDifferByNorth = table_of([](unsigned equal) {
  return 64 | (equal & 1U) << 1U | has_both(equal) << 4U;
});
alignas(16) inline constexpr ByteTable kDifferByBelow = table_of([](unsigned equal) {
  return (equal >> 1U & 1U) | has_both(equal) << 5U;
});
alignas(16) inline constexpr ByteTable kDifferBySouth = table_of([](unsigned equal) {
  return (equal >> 1U & 1U) << 2U;
});

// From that byte: upright, level and level south of odd columns' contexts, if west and east are equal and if
// they differ.
constexpr unsigned upright_level(unsigned differ) {
  return (differ >> 1U & 1U) | (differ & 1U) << 1U | (differ & 4U);
}
alignas(16) inline constexpr ByteTable kOddEqual = table_of([](unsigned differ) {
  return 64 | upright_level(differ) << 3U;
});
alignas(16) inline constexpr ByteTable kOddDiffer = table_of([](unsigned differ) {
  return 128 | upright_level(differ) << 4U;
});

/// Positions of the rows of a wave and around them, from row y = 0.
struct NearRows {
  HWY_INLINE NearRows(WaveBytes& voxels, WaveBytes& equals, int wave)
      : now{voxels.of(wave)},
        north{voxels.of(wave + 3)},
        below{voxels.of(wave + 2) - kRowBytes},
        below_north{voxels.of(wave + 1) - kRowBytes},
        below_south{north - kRowBytes},
        equals_now{equals.of(wave)},
        equals_north{equals.of(wave + 3)},
        equals_below{equals.of(wave + 2) - kRowBytes} {}

  std::uint8_t* now;
  std::uint8_t* north;
  std::uint8_t* below;
  std::uint8_t* below_north;
  std::uint8_t* below_south;
  std::uint8_t* equals_now;
  std::uint8_t* equals_north;
  std::uint8_t* equals_below;
};

/// Fills in missing neighbours of a wave's rows, as rows_around() defines.
HWY_INLINE void add_missing_rows(const NearRows& rows, int wave) {
  const hn::CappedTag<std::uint8_t, kRowBytes> d;
  for (std::size_t i = 0; i < kRowBytes; i += hn::MaxLanes(d)) {
    if (wave < kChunkSize) {
      // Row y = 0: all other rows are north.
      const auto north = hn::LoadU(d, rows.north + i);
      hn::StoreU(north, d, rows.below + i);
      hn::StoreU(north, d, rows.below_north + i);
      hn::StoreU(north, d, rows.below_south + i);
      const auto equals = hn::LoadU(d, rows.equals_north + i);
      hn::StoreU(hn::Or(equals, hn::Set(d, kEqualsNorth)), d, rows.equals_below + i);
      hn::StoreU(hn::Set(d, kEqualsAll), d, rows.equals_north - kRowBytes + i);
    } else if (wave % 2 != 0) {
      // z = 31: below south is below.
      const std::size_t at = static_cast<std::size_t>(first_row_of(wave)) * kRowBytes + i;
      hn::StoreU(hn::LoadU(d, rows.below + at), d, rows.below_south + at);
      hn::StoreU(hn::Set(d, kEqualsAll), d, rows.equals_north - kRowBytes + at);
    }
    if (wave != 0 && wave % 2 == 0 && wave / 2 < kChunkSize) {
      // z = 0: north and below north are below.
      const std::size_t at = static_cast<std::size_t>(wave / 2) * kRowBytes + i;
      const auto below = hn::LoadU(d, rows.below + at);
      hn::StoreU(below, d, rows.north + at);
      hn::StoreU(below, d, rows.below_north + at);
      const auto equals = hn::LoadU(d, rows.equals_below + at);
      hn::StoreU(hn::Or(equals, hn::Set(d, kEqualsBelow)), d, rows.equals_north + at);
    }
  }
}

/// Part of a wave with everything known before its voxels.
struct NearPart {
  std::size_t at;  // its place in NearRows
  PartVec north;
  PartVec below;
  PartVec around;  // the surroundings
  PartVec differ;  // context if north and below differ
  PartMask same;
  PartMask level;
  PartVec base;
  PartVec other;
};

HWY_INLINE NearPart near_part(const NearRows& rows, std::size_t part) {
  NearPart near;
  near.at = part * kPartBytes;
  near.north = load(rows.north + near.at);
  near.below = load(rows.below + near.at);
  const PartVec south = load_row_before(rows.north + near.at);
  const PartVec of_north = load(rows.equals_north + near.at);
  const PartVec of_below = load(rows.equals_below + near.at);
  const PartVec of_south = load_row_before(rows.equals_north + near.at);
  near.around = hn::OrAnd(hn::OrAnd(hn::And(of_north, bytes_of(1 + 4 + 8)), of_below, bytes_of(16 + 32)),
                          of_south, bytes_of(2));
  near.same = hn::Eq(near.north, near.below);
  near.differ = hn::Or(hn::Or(look_up(kDifferByNorth, of_north), look_up(kDifferByBelow, of_below)),
                       or_where(look_up(kDifferBySouth, of_south), hn::Eq(south, near.north), 8));
  near.level = hn::TestBit(near.differ, bytes_of(1));
  near.base = hn::IfThenElse(near.level, near.north, near.below);
  near.other = hn::IfThenElse(near.level, near.below, near.north);
  return near;
}

/// Half the columns of a part with everything known before they are coded.
struct HalfPart {
  PartVec first;   // the first candidate
  PartVec second;  // second candidate, unless all near voxels are alike
  PartMask alike;
  PartMask steady;
  PartVec context;
};

HWY_INLINE PartMask is_all_around(const NearPart& near) {
  return hn::Eq(near.around, bytes_of(kEqualsAll));
}

HWY_INLINE HalfPart even_half(const NearPart& near) {
  return {near.base, near.other, near.same, hn::And(near.same, is_all_around(near)),
          hn::IfThenElse(near.same, near.around, near.differ)};
}

/// Odd columns; `now` has the even ones. `bytes`: address of the part.
HWY_INLINE HalfPart odd_half(const NearPart& near, PartVec now, const std::uint8_t* bytes, std::size_t part) {
  const PartVec west = west_of(now, bytes);
  const PartVec east = hn::IfThenElse(columns<IsLastColumn>(part), west, east_of(now, bytes));
  const PartMask equal = hn::Eq(west, east);
  const PartMask base_west = hn::Eq(near.base, west);
  const PartMask base_east = hn::Eq(near.base, east);
  // If west and east are equal, either is right.
  const PartMask is_east = hn::Or(base_east, hn::AndNot(base_west, hn::Eq(near.other, east)));
  HalfPart half;
  half.first = hn::IfThenElse(is_east, east, west);
  const PartVec second = hn::IfThenElse(is_east, west, east);
  const PartMask base_first = hn::Or(base_west, base_east);
  const PartMask other_first = hn::Eq(near.other, half.first);
  half.alike = hn::And(equal, hn::And(base_first, other_first));
  half.steady = hn::And(half.alike, is_all_around(near));
  half.second = hn::IfThenElse(equal, hn::IfThenElse(base_west, near.other, near.base), second);
  // If west and east differ, base is not the second: it would be the first.
  const PartVec of_equal = or_where(look_up(kOddEqual, near.differ), near.same, 4);
  const PartVec of_differ = or_where(look_up(kOddDiffer, near.differ), hn::Eq(near.other, second), 8);
  const PartVec context =
      or_where(or_where(hn::IfThenElse(equal, of_equal, of_differ), base_first, 1), other_first, 2);
  half.context = hn::IfThenElse(half.alike, near.around, context);
  return half;
}

/// Stores the equalities of a part's voxels, now known. Returns the voxels that differ from a neighbour.
HWY_INLINE PartBits find_equals(const NearRows& rows, const NearPart& near, PartVec now, std::size_t part,
                                int wave) {
  const std::uint8_t* const bytes = rows.now + near.at;
  const PartMask west = hn::Or(hn::Eq(now, west_of(now, bytes)), columns<IsFirstColumn>(part));
  const PartMask east = hn::Or(hn::Eq(now, east_of(now, bytes)), columns<IsLastColumn>(part));
  // Rows without a row to the north or below: it counts as equal.
  alignas(64) static constexpr auto kNoBelow = [] {
    std::array<std::uint8_t, (kChunkSize + 2) * kRowBytes> bytes_of_rows{};
    for (std::size_t i = 0; i < kRowBytes; ++i) bytes_of_rows[i] = kEqualsBelow;
    return bytes_of_rows;
  }();
  alignas(64) static constexpr auto kNoNorth = [] {
    std::array<std::uint8_t, (2 * kWaves + 8) * kRowBytes> bytes_of_rows{};
    for (std::size_t i = 0; i < kRowBytes; ++i) bytes_of_rows[kWaves * kRowBytes + i] = kEqualsNorth;
    return bytes_of_rows;
  }();
  const std::size_t row_without = wave % 2 == 0 ? static_cast<std::size_t>(wave) / 2 : kChunkSize + 8;
  PartVec equals = hn::Or(load(kNoBelow.data() + near.at),
                          load(kNoNorth.data() + (kWaves - row_without) * kRowBytes + near.at));
  equals = or_where(equals, hn::Eq(now, near.below), kEqualsBelow);
  equals = or_where(equals, hn::Eq(now, near.north), kEqualsNorth);
  equals = or_where(equals, west, kEqualsWest);
  equals = or_where(equals, east, kEqualsEast);
  store(equals, rows.equals_now + near.at);
  return bits_of(hn::Ne(equals, bytes_of(kEqualsAll)));
}

/// Adds the other halves of rows that `parts` contains in halves: the west or east of a voxel in the middle
/// of a row is in the other half.
HWY_INLINE PartSet whole_rows(PartSet parts) {
  constexpr PartSet kFirstHalves = 0x5555555555555555;
  if constexpr (kPartBytes < kRowBytes) parts |= (parts & kFirstHalves) << 1U | (parts >> 1U & kFirstHalves);
  return parts;
}

/// Parts of the last waves with voxels that differ from any around: voxels that are not near such a part are
/// steady.
class UnequalParts {
 public:
  /// Parts of a wave that are near one.
  [[nodiscard]] HWY_INLINE PartSet near(int wave) const {
    constexpr std::size_t kRow = kPartBytes < kRowBytes ? kRowBytes / kPartBytes : 1;
    const PartSet last =
        of_[static_cast<std::size_t>(wave + 3) % 4] | of_[static_cast<std::size_t>(wave + 2) % 4];
    return last | last << kRow;
  }
  HWY_INLINE void set(int wave, PartSet parts) { of_[static_cast<std::size_t>(wave) % 4] = parts; }

 private:
  std::array<PartSet, 4> of_{};
};

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
