// Rows of 32 voxels as vectors.
// Included once for each instruction set, hence no include guard but this:
#if defined(TALUS_VOLUME_ROWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_ROWS_INL
#undef TALUS_VOLUME_ROWS_INL
#else
#define TALUS_VOLUME_ROWS_INL
#endif

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <hwy/highway.h>

#include "rans-inl.h"
#include "volume_masks-inl.h"

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
#elif HWY_TARGET == HWY_AVX2
  const __m256i first = _mm256_cmpeq_epi16(a.part[0].raw, b.part[0].raw);
  const __m256i second = _mm256_cmpeq_epi16(a.part[1].raw, b.part[1].raw);
  // Packed within lanes: their quarters come in turns.
  const __m256i bytes = _mm256_permute4x64_epi64(_mm256_packs_epi16(first, second), 0xD8);
  return static_cast<RowMask>(_mm256_movemask_epi8(bytes));
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
#elif HWY_TARGET == HWY_AVX2
    const __m256i bits =
        _mm256_setr_epi16(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, -32768);
    const __m256i all = _mm256_set1_epi16(static_cast<short>(where >> (16 * p)));
    const hn::Mask<Voxels> mask{_mm256_cmpeq_epi16(_mm256_and_si256(all, bits), bits)};
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

/// The voxels to the west; what stands in the first column means nothing. `voxels`: where the row lies, with
/// a voxel before it.
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

/// Writes numbers of `count` bits of the `coded` voxels of a row, at most kLanes of them, side by side;
/// bits(b) is bit b of each. It writes up to the next multiple of 8.
template <std::size_t count, class Bits>
HWY_INLINE void put_numbers(RowMask coded, const Bits& bits, std::uint8_t* out) {
  std::array<std::uint32_t, count> packed;
  for (std::size_t b = 0; b < count; ++b) packed[b] = extract_bits(bits(b), coded);
  for (int left = std::popcount(coded); left > 0; left -= 8, out += 8) {
    std::uint64_t numbers = 0;
    for (std::size_t b = 0; b < count; ++b) {
      numbers |= kBitsAsBytes[packed[b] & 0xFFU] << b;
      packed[b] >>= 8U;
    }
    std::memcpy(out, &numbers, sizeof numbers);
  }
}

/// Calls visit(i) for each bit i that is set.
template <class Visit>
HWY_INLINE void over_bits(std::uint32_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
