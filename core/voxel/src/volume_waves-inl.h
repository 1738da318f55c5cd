// The rows of a wave at once: a vector has a mask of each.
// Included once for each instruction set, hence no include guard but this:
#if defined(TALUS_VOLUME_WAVES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_WAVES_INL
#undef TALUS_VOLUME_WAVES_INL
#else
#define TALUS_VOLUME_WAVES_INL
#endif

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "volume_model.h"
#include "volume_pack.h"
#include "volume_rows-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

// A wave's masks, one to a row: sixteen rows at most.
inline constexpr std::size_t kWaveRows = 16;
using MaskTag = hn::CappedTag<std::uint32_t, kWaveRows>;
constexpr std::size_t kMaskParts =
    kWaveRows * sizeof(RowMask) / HWY_MAX_BYTES == 0 ? 1 : kWaveRows * sizeof(RowMask) / HWY_MAX_BYTES;
struct MaskVec {
  hn::Vec<MaskTag> part[kMaskParts];

  template <class Operation>
  HWY_INLINE MaskVec with(const MaskVec& other, const Operation& operation) const {
    MaskVec result;
    for (std::size_t p = 0; p < kMaskParts; ++p) result.part[p] = operation(part[p], other.part[p]);
    return result;
  }
  friend HWY_INLINE MaskVec operator&(const MaskVec& a, const MaskVec& b) {
    return a.with(b, [](auto x, auto y) HWY_ATTR { return hn::And(x, y); });
  }
  friend HWY_INLINE MaskVec operator|(const MaskVec& a, const MaskVec& b) {
    return a.with(b, [](auto x, auto y) HWY_ATTR { return hn::Or(x, y); });
  }
  HWY_INLINE MaskVec operator~() const {
    return with(*this, [](auto x, auto) HWY_ATTR { return hn::Not(x); });
  }
};

/// The masks of a wave's rows, in the order of the rows.
using WaveMasks = std::array<RowMask, kWaveRows>;

HWY_INLINE MaskVec load_masks(const RowMask* masks) {
  const MaskTag d;
  MaskVec vec;
  for (std::size_t p = 0; p < kMaskParts; ++p) vec.part[p] = hn::LoadU(d, masks + p * hn::MaxLanes(d));
  return vec;
}

HWY_INLINE void store_masks(const MaskVec& vec, RowMask* masks) {
  const MaskTag d;
  for (std::size_t p = 0; p < kMaskParts; ++p) hn::StoreU(vec.part[p], d, masks + p * hn::MaxLanes(d));
}

HWY_INLINE MaskVec set_masks(RowMask mask) {
  MaskVec vec;
  for (std::size_t p = 0; p < kMaskParts; ++p) vec.part[p] = hn::Set(MaskTag{}, mask);
  return vec;
}

/// The masks of the voxels one to the east of each, where these have the masks of their wests.
HWY_INLINE MaskVec of_east(const MaskVec& west) {
  return west.with(set_masks(1U << 31U),
                   [](auto x, auto last) HWY_ATTR { return hn::Or(hn::ShiftRight<1>(x), last); });
}

/// Where the rows of a wave lie, and those around them: for rows[i] sets voxels and around. `row_zero` as for
/// rows_around().
template <class Row>
HWY_INLINE void place_rows(decltype(Row::voxels) voxels, const MaterialId* row_zero, int wave,
                           std::array<Row, kWaveRows>& rows) {
  const int first = first_row_of(wave);
  const int last = last_row_of(wave);
  const auto place = [&](int y) HWY_ATTR {
    Row& row = rows[static_cast<std::size_t>(y - first)];
    row.voxels = voxels + (y * kChunkSize + wave - 2 * y) * kChunkSize;
    row.around = rows_around(voxels, row_zero, y, wave - 2 * y);
  };
  place(first);
  place(last);
  if (last - first < 2) return;
  auto* at = rows[0].voxels;
  for (std::size_t i = 1; i < static_cast<std::size_t>(last - first); ++i) {
    at += kRowToRow;
    rows[i].voxels = at;
    rows[i].around = rows_inside(at);
  }
}

/// Masks of a wave's rows that are found row by row.
class GrowingMasks {
 public:
  HWY_INLINE void clear() {
#if HWY_TARGET == HWY_AVX3
    masks_ = set_masks(kAllColumns);
#else
    store_masks(set_masks(kAllColumns), masks_.data());
#endif
  }
  HWY_INLINE void set(std::size_t i, RowMask mask) {
#if HWY_TARGET == HWY_AVX3
    // In the vector itself: one that is loaded right after its parts were stored is late.
    auto& vec = masks_.part[0].raw;
    vec = _mm512_mask_set1_epi32(vec, static_cast<__mmask16>(1U << i), static_cast<int>(mask));
#else
    masks_[i] = mask;
#endif
  }
  [[nodiscard]] HWY_INLINE MaskVec get() const {
#if HWY_TARGET == HWY_AVX3
    return masks_;
#else
    return load_masks(masks_.data());
#endif
  }

 private:
#if HWY_TARGET == HWY_AVX3
  MaskVec masks_;
#else
  WaveMasks masks_;
#endif
};

/// Masks of a wave's rows where single rows are looked at.
struct AroundArrays {
  AroundMasks<WaveMasks> of;

  HWY_INLINE void store(const AroundMasks<MaskVec>& masks) {
    store_masks(masks.upright, of.upright.data());
    store_masks(masks.level, of.level.data());
    store_masks(masks.level_south, of.level_south.data());
    store_masks(masks.west_n, of.west_n.data());
    store_masks(masks.east_n, of.east_n.data());
    store_masks(masks.west_b, of.west_b.data());
    store_masks(masks.east_b, of.east_b.data());
  }
  [[nodiscard]] HWY_INLINE AroundMasks<RowMask> row(std::size_t i) const {
    return {of.upright[i], of.level[i],  of.level_south[i], of.west_n[i],
            of.east_n[i],  of.west_b[i], of.east_b[i]};
  }
};

/// How the odd columns of a wave's rows stand to their neighbours; ones where a row is not looked at.
struct GrowingBeside {
  BesideMasks<GrowingMasks> of;

  HWY_INLINE void clear() {
    for (GrowingMasks* masks : {&of.equal, &of.base_west, &of.base_east, &of.other_west, &of.other_east}) {
      masks->clear();
    }
  }
  [[nodiscard]] HWY_INLINE BesideMasks<MaskVec> get() const {
    return {of.equal.get(), of.base_west.get(), of.base_east.get(), of.other_west.get(), of.other_east.get()};
  }
  /// Gives where the east is the first candidate.
  HWY_INLINE RowMask set(std::size_t i, const RowVec& base, const RowVec& other, const RowVec& west,
                         const RowVec& east) {
    const BesideMasks<RowMask> row{equal(west, east) | 1U << 31U, equal(base, west), equal(base, east),
                                   equal(other, west), equal(other, east)};
    of.equal.set(i, row.equal);
    of.base_west.set(i, row.base_west);
    of.base_east.set(i, row.base_east);
    of.other_west.set(i, row.other_west);
    of.other_east.set(i, row.other_east);
    return row.is_east();
  }
};

/// What is looked at of single rows.
struct BesideArrays {
  WaveMasks equal;
  WaveMasks base_west;
  WaveMasks agrees;
  WaveMasks is_east;

  HWY_INLINE void store(const BesideMasks<MaskVec>& beside) {
    store_masks(beside.equal, equal.data());
    store_masks(beside.base_west, base_west.data());
    store_masks(beside.agrees(), agrees.data());
    store_masks(beside.is_east(), is_east.data());
  }
};

/// Ones for the first `rows` rows of a wave.
HWY_INLINE MaskVec mask_of_rows(std::size_t rows) {
  static constexpr auto kMasks = [] {
    std::array<RowMask, 2 * kWaveRows> masks{};
    for (std::size_t i = 0; i < kWaveRows; ++i) masks[i] = kAllColumns;
    return masks;
  }();
  return load_masks(kMasks.data() + kWaveRows - rows);
}

/// Bit i is set where the mask of row i is not 0.
HWY_INLINE std::uint32_t rows_with_any(const MaskVec& masks) {
  const MaskTag d;
  std::uint32_t rows = 0;
  for (std::size_t p = 0; p < kMaskParts; ++p) {
    const auto any = hn::Ne(masks.part[p], hn::Zero(d));
#if HWY_TARGET == HWY_AVX3
    rows |= std::uint32_t{any.raw};
#elif HWY_TARGET == HWY_AVX2
    rows |= static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(any.raw))) << (8 * p);
#else
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, any, bits);
    rows |= std::uint32_t{bits[0]} << (p * hn::MaxLanes(d));
#endif
  }
  return rows;
}

/// What a wave's rows have to code: which voxels are steady, which are coded, and their contexts bit by bit.
struct BatchMasks {
  alignas(64) WaveMasks steady;
  WaveMasks coded;
  std::array<WaveMasks, 8> context;
  std::uint32_t coded_rows = 0;  // bit i: row i has coded voxels

  /// `half`: the even or the odd columns of the wave's rows.
  template <std::size_t bits>
  HWY_INLINE void store(const MaskVec& half, const MaskVec& is_steady, const ContextBits<MaskVec>& contexts) {
    const MaskVec is_coded = half & ~is_steady;
    store_masks(half & is_steady, steady.data());
    store_masks(is_coded, coded.data());
    coded_rows = rows_with_any(is_coded);
    for (std::size_t b = 0; b < bits; ++b) store_masks(contexts[b], context[b].data());
    if constexpr (bits < 8) store_masks(set_masks(0), context[7].data());
  }
  /// Writes the contexts of the coded voxels side by side, row by row; gives how many.
  template <std::size_t bits>
  HWY_INLINE std::size_t put_contexts(const VolumePack* pack, std::uint8_t* out) const {
    if (HWY_TARGET <= HWY_AVX3 && pack != nullptr) {
      return pack->contexts({coded.data(), coded_rows}, context[0].data(), out);
    }
    std::size_t size = 0;
    over_bits(coded_rows, [&](std::size_t i) HWY_ATTR {
      put_numbers<bits>(
          coded[i], [&](std::size_t b) { return context[b][i]; }, out + size);
      size += static_cast<std::size_t>(std::popcount(coded[i]));
    });
    return size;
  }
  [[nodiscard]] HWY_INLINE std::uint32_t steady_voxels() const {
    int count = 0;
    for (std::size_t i = 0; i < kWaveRows; i += 2) {
      count += std::popcount(steady[i] | std::uint64_t{steady[i + 1]} << 32U);
    }
    return static_cast<std::uint32_t>(count);
  }
};

/// Which voxels of the rows of the last waves equal a neighbour. A row that is not there has masks of ones,
/// so that each row finds what rows_around() of volume_model.h says.
class EqualMasks {
 public:
  EqualMasks() {
    for (Masks& masks : west_) masks.fill(kAllColumns);
    north_ = below_ = west_;
  }

  /// Of the rows of a wave, from its first one on.
  [[nodiscard]] HWY_INLINE AroundMasks<MaskVec> around(int wave) {
    const auto w = static_cast<std::size_t>(wave);
    const auto y = static_cast<std::size_t>(first_row_of(wave)) + 1;
    RowMask* const west_north = west_[(w + 3) % 4].data() + y;
    RowMask* const west_below = west_[(w + 2) % 4].data() + y - 1;
    if (wave < kChunkSize) *west_below = *west_north;  // row y = 0: below is north
    const auto last = static_cast<std::size_t>(last_row_of(wave)) + 1 - y;
    if (wave % 2 == 0 && wave / 2 < kChunkSize) west_north[last] = west_below[last];  // z = 0: north is below
    const MaskVec west_n = load_masks(west_north);
    const MaskVec west_b = load_masks(west_below);
    return {load_masks(below_[(w + 3) % 4].data() + y),
            load_masks(north_[(w + 2) % 4].data() + y - 1),
            load_masks(north_[(w + 3) % 4].data() + y - 1),
            west_n,
            of_east(west_n),
            west_b,
            of_east(west_b)};
  }

  /// Makes room for the masks of a wave.
  HWY_INLINE void begin(int wave) {
    const std::size_t w = static_cast<std::size_t>(wave) % 4;
    for (Masks* masks : {&west_[w], &north_[w], &below_[w]}) {
      for (std::size_t i = 0; i < masks->size(); i += kWaveRows)
        store_masks(set_masks(kAllColumns), masks->data() + i);
    }
  }

  /// `west`, `north`, `below`: where the voxels of row (y, z) equal those there.
  HWY_INLINE void set(int y, int z, RowMask west, RowMask north, RowMask below) {
    const auto w = static_cast<std::size_t>(z + 2 * y) % 4;
    const auto at = static_cast<std::size_t>(y) + 1;
    west_[w][at] = west | 1U;
    if (z != 0) north_[w][at] = north;
    if (y != 0) below_[w][at] = below;
  }

 private:
  // By wave, modulo 4, and row, from y = -1 on.
  using Masks = std::array<RowMask, 64>;
  std::array<Masks, 4> west_;
  std::array<Masks, 4> north_;
  std::array<Masks, 4> below_;
};

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
