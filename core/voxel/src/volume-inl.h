// Rows of 32 voxels as vectors. Included once for each instruction set, hence no include guard but this:
#if defined(TALUS_VOLUME_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_INL
#undef TALUS_VOLUME_INL
#else
#define TALUS_VOLUME_INL
#endif

#include <hwy/highway.h>

#include "rans-inl.h"
#include "volume_masks.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

using Voxels = hn::CappedTag<std::uint16_t, kChunkSize>;
constexpr std::size_t kRowParts = kChunkSize * sizeof(std::uint16_t) / HWY_MAX_BYTES == 0
                                      ? 1
                                      : kChunkSize * sizeof(std::uint16_t) / HWY_MAX_BYTES;
struct RowVec {
  hn::Vec<Voxels> part[kRowParts];
};

HWY_INLINE RowVec load_voxels(const MaterialId* voxels) {
  const Voxels d;
  RowVec row;
  for (std::size_t p = 0; p < kRowParts; ++p) {
    row.part[p] = hn::LoadU(d, reinterpret_cast<const std::uint16_t*>(voxels) + p * hn::MaxLanes(d));
  }
  return row;
}

HWY_INLINE void store_voxels(const RowVec& row, MaterialId* voxels) {
  const Voxels d;
  for (std::size_t p = 0; p < kRowParts; ++p) {
    hn::StoreU(row.part[p], d, reinterpret_cast<std::uint16_t*>(voxels) + p * hn::MaxLanes(d));
  }
}

HWY_INLINE RowMask equal(const RowVec& a, const RowVec& b) {
#if HWY_TARGET == HWY_AVX3
  return hn::Eq(a.part[0], b.part[0]).raw;
#else
  const Voxels d;
  RowMask mask = 0;
  for (std::size_t p = 0; p < kRowParts; ++p) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Eq(a.part[p], b.part[p]), bits);
    const RowMask part = hn::MaxLanes(d) > 8 ? bits[0] | RowMask{bits[1]} << 8U : RowMask{bits[0]};
    mask |= part << (p * hn::MaxLanes(d));
  }
  return mask;
#endif
}

HWY_INLINE RowVec select(RowMask where, const RowVec& yes, const RowVec& no) {
  const Voxels d;
  RowVec row;
  for (std::size_t p = 0; p < kRowParts; ++p) {
#if HWY_TARGET == HWY_AVX3
    const hn::Mask<Voxels> mask{static_cast<__mmask32>(where)};
#else
    std::uint8_t bits[8] = {static_cast<std::uint8_t>(where >> (p * hn::MaxLanes(d))),
                            static_cast<std::uint8_t>(where >> (p * hn::MaxLanes(d)) >> 8U)};
    const auto mask = hn::LoadMaskBits(d, bits);
#endif
    row.part[p] = hn::IfThenElse(mask, yes.part[p], no.part[p]);
  }
  return row;
}

/// The bits of `bits` where `mask` has any, side by side from the lowest.
HWY_INLINE std::uint32_t extract_bits(std::uint32_t bits, std::uint32_t mask) {
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
  return _pext_u32(bits, mask);
#else
  std::uint32_t found = 0;
  for (std::uint32_t place = 0; mask != 0; mask &= mask - 1, ++place) {
    found |= (bits >> std::countr_zero(mask) & 1U) << place;
  }
  return found;
#endif
}

/// The other way round.
HWY_INLINE std::uint32_t deposit_bits(std::uint32_t bits, std::uint32_t mask) {
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
  return _pdep_u32(bits, mask);
#else
  std::uint32_t found = 0;
  for (; mask != 0; mask &= mask - 1, bits >>= 1U) {
    if ((bits & 1U) != 0) found |= mask & (~mask + 1);
  }
  return found;
#endif
}

/// The voxels to the west; what stands in the first column means nothing. `voxels`: where the row lies, with a
/// voxel before it.
HWY_INLINE RowVec west_of(const RowVec& row, const MaterialId* voxels) {
#if HWY_TARGET == HWY_AVX3
  (void)voxels;
  alignas(64) static constexpr auto kPlaces = [] {
    std::array<std::uint16_t, kChunkSize> places{};
    for (std::uint16_t i = 1; i < kChunkSize; ++i) places[i] = static_cast<std::uint16_t>(i - 1);
    return places;
  }();
  return {{hn::Vec<Voxels>{_mm512_permutexvar_epi16(_mm512_load_si512(kPlaces.data()), row.part[0].raw)}}};
#else
  (void)row;
  return load_voxels(voxels - 1);
#endif
}

/// The same to the east, of the last column.
HWY_INLINE RowVec east_of(const RowVec& row, const MaterialId* voxels) {
#if HWY_TARGET == HWY_AVX3
  (void)voxels;
  alignas(64) static constexpr auto kPlaces = [] {
    std::array<std::uint16_t, kChunkSize> places{};
    for (std::uint16_t i = 0; i + 1 < kChunkSize; ++i) places[i] = static_cast<std::uint16_t>(i + 1);
    return places;
  }();
  return {{hn::Vec<Voxels>{_mm512_permutexvar_epi16(_mm512_load_si512(kPlaces.data()), row.part[0].raw)}}};
#else
  (void)row;
  return load_voxels(voxels + 1);
#endif
}

/// Writes the numbers of `coded` voxels, at most kLanes of them, side by side, that `bits` has bit for bit; it
/// may write kLanes of them in any case.
template <std::size_t count, class Bits>
HWY_INLINE void put_numbers(RowMask coded, const Bits& bits, std::uint8_t* out) {
#if HWY_TARGET == HWY_AVX3
  __m128i numbers = _mm_setzero_si128();
  for (std::size_t b = 0; b < count; ++b) {
    const auto lanes = static_cast<__mmask16>(extract_bits(bits[b], coded));
    numbers = _mm_or_si128(numbers, _mm_maskz_set1_epi8(lanes, static_cast<char>(1U << b)));
  }
  _mm_storeu_si128(reinterpret_cast<__m128i*>(out), numbers);
#else
  std::array<std::uint32_t, count> packed;
  for (std::size_t b = 0; b < count; ++b) packed[b] = extract_bits(bits[b], coded);
  for (int left = std::popcount(coded); left > 0; left -= 8, out += 8) {
    std::uint64_t numbers = 0;
    for (std::size_t b = 0; b < count; ++b) {
      numbers |= kBitsAsBytes[packed[b] & 0xFFU] << b;
      packed[b] >>= 8U;
    }
    std::memcpy(out, &numbers, sizeof numbers);
  }
#endif
}

/// Where north and below agree: the first of the voxels around that differs from them.
HWY_INLINE RowVec first_different(const AroundMasks& masks, const RowsAround& around) {
  RowVec found = load_voxels(around.below_north);
  found = select(masks.level_south, found, load_voxels(around.below_south));
  found = select(masks.west_b, found, load_voxels(around.below - 1));
  found = select(masks.east_b, found, load_voxels(around.below + 1));
  found = select(masks.west_n, found, load_voxels(around.north - 1));
  return select(masks.east_n, found, load_voxels(around.north + 1));
}

/// The first of the voxels around that is neither of two candidates; `exists` says where there is one.
HWY_INLINE RowVec third_candidate(const RowVec& first, const RowVec& second, const AroundMasks& masks,
                                  const RowsAround& around, RowMask& exists) {
  const RowVec north = load_voxels(around.north);
  const RowVec below = load_voxels(around.below);
  RowVec found = load_voxels(around.below_north);
  exists = ~(equal(found, first) | equal(found, second));
  const auto prefer = [&](const RowVec& candidate, RowMask where) HWY_ATTR {
    const RowMask differs = where & ~(equal(candidate, first) | equal(candidate, second));
    found = select(differs, candidate, found);
    exists |= differs;
  };
  constexpr RowMask kHasWest = ~RowMask{1};
  constexpr RowMask kHasEast = kAllColumns >> 1U;
  prefer(load_voxels(around.below_south), kAllColumns);
  prefer(load_voxels(around.below - 1), kHasWest);
  prefer(load_voxels(around.below + 1), kHasEast);
  prefer(load_voxels(around.north - 1), kHasWest);
  prefer(load_voxels(around.north + 1), kHasEast);
  prefer(select(masks.level, below, north), kAllColumns);
  prefer(select(masks.level, north, below), kAllColumns);
  return found;
}

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
