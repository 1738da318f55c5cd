// Rows of a wave side by side, one byte per voxel, in vectors: a part of a wave has as many voxels as a
// vector has lanes, which is two rows, one, or half a row.
// Included once per instruction set, hence this guard:
#if defined(TALUS_VOLUME_PARTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_VOLUME_PARTS_INL
#undef TALUS_VOLUME_PARTS_INL
#else
#define TALUS_VOLUME_PARTS_INL
#endif

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "rans-inl.h"
#include "volume_model.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

inline constexpr std::size_t kRowBytes = kChunkSize;

using Part = hn::CappedTag<std::uint8_t, 2 * kRowBytes>;
using PartVec = hn::Vec<Part>;
using PartMask = hn::Mask<Part>;
#if HWY_TARGET == HWY_AVX3
inline constexpr std::size_t kPartBytes = 2 * kRowBytes;
using PartBits = std::uint64_t;
#elif HWY_TARGET == HWY_AVX2
inline constexpr std::size_t kPartBytes = kRowBytes;
using PartBits = std::uint32_t;
#else
inline constexpr std::size_t kPartBytes = kRowBytes / 2;
using PartBits = std::uint32_t;
#endif
inline constexpr PartBits kAllBits = static_cast<PartBits>(~std::uint64_t{0} >> (64 - kPartBytes));
inline constexpr PartBits kEvenBits = static_cast<PartBits>(0x5555555555555555U & kAllBits);
inline constexpr PartBits kOddBits = static_cast<PartBits>(kAllBits ^ kEvenBits);

// A wave has at most sixteen rows, which may begin in the middle of a part.
inline constexpr std::size_t kWaveRows = 16;
inline constexpr std::size_t kMaxParts =
    kPartBytes > kRowBytes ? kWaveRows / 2 + 1 : kWaveRows* kRowBytes / kPartBytes;

/// Parts of a wave, counted from row y = 0: bit p is part p.
using PartSet = std::uint64_t;

HWY_INLINE PartVec load(const std::uint8_t* bytes) {
  return hn::LoadU(Part{}, bytes);
}
HWY_INLINE void store(PartVec vec, std::uint8_t* bytes) {
  hn::StoreU(vec, Part{}, bytes);
}
HWY_INLINE PartVec bytes_of(std::uint8_t value) {
  return hn::Set(Part{}, value);
}
HWY_INLINE PartVec or_where(PartVec vec, PartMask where, std::uint8_t bits) {
  return hn::Or(vec, hn::IfThenElseZero(where, bytes_of(bits)));
}

HWY_INLINE PartBits bits_of(PartMask mask) {
#if HWY_TARGET == HWY_AVX3
  return mask.raw;
#elif HWY_TARGET == HWY_AVX2
  return static_cast<PartBits>(_mm256_movemask_epi8(mask.raw));
#else
  std::uint8_t bits[8] = {};  // StoreMaskBits may write eight
  hn::StoreMaskBits(Part{}, mask, bits);
  return bits[0] | PartBits{bits[1]} << 8U;
#endif
}

HWY_INLINE PartMask mask_of(PartBits bits) {
#if HWY_TARGET == HWY_AVX3
  return PartMask{static_cast<__mmask64>(bits)};
#else
  std::uint8_t bytes[8] = {};
  for (std::size_t i = 0; i < sizeof bits; ++i) bytes[i] = static_cast<std::uint8_t>(bits >> (8 * i));
  return hn::LoadMaskBits(Part{}, bytes);
#endif
}

/// Mask of the pattern's columns in all rows of a part.
template <class Pattern>
HWY_INLINE PartMask columns(std::size_t part) {
#if HWY_TARGET == HWY_AVX3
  (void)part;
  static constexpr std::uint64_t kBits = [] {
    std::uint64_t bits = 0;
    for (std::size_t x = 0; x < 2 * kRowBytes; ++x) bits |= std::uint64_t{Pattern{}(x % kRowBytes)} << x;
    return bits;
  }();
  return mask_of(kBits);
#else
  alignas(32) static constexpr auto kBytes = [] {
    std::array<std::uint8_t, kRowBytes> bytes{};
    for (std::size_t x = 0; x < kRowBytes; ++x) bytes[x] = Pattern{}(x) ? 0xFF : 0;
    return bytes;
  }();
  return hn::MaskFromVec(load(kBytes.data() + part * kPartBytes % kRowBytes));
#endif
}
struct IsFirstColumn {
  constexpr bool operator()(std::size_t x) const { return x == 0; }
};
struct IsLastColumn {
  constexpr bool operator()(std::size_t x) const { return x == kRowBytes - 1; }
};
struct IsOddColumn {
  constexpr bool operator()(std::size_t x) const { return x % 2 != 0; }
};

/// Bytes of the voxels to the west; undefined in the first columns. `bytes`: address of the vector, with a
/// readable byte before it.
HWY_INLINE PartVec west_of(PartVec vec, const std::uint8_t* bytes) {
#if HWY_TARGET == HWY_AVX3
  (void)bytes;
  return PartVec{_mm512_alignr_epi8(vec.raw, _mm512_alignr_epi64(vec.raw, vec.raw, 6), 15)};
#elif HWY_TARGET == HWY_AVX2
  (void)bytes;
  return PartVec{_mm256_alignr_epi8(vec.raw, _mm256_permute2x128_si256(vec.raw, vec.raw, 0x08), 15)};
#else
  (void)vec;
  return load(bytes - 1);
#endif
}

/// Bytes of the voxels to the east; undefined in the last columns.
HWY_INLINE PartVec east_of(PartVec vec, const std::uint8_t* bytes) {
#if HWY_TARGET == HWY_AVX3
  (void)bytes;
  return PartVec{_mm512_alignr_epi8(_mm512_alignr_epi64(vec.raw, vec.raw, 2), vec.raw, 1)};
#elif HWY_TARGET == HWY_AVX2
  (void)bytes;
  return PartVec{_mm256_alignr_epi8(_mm256_permute2x128_si256(vec.raw, vec.raw, 0x81), vec.raw, 1)};
#else
  (void)vec;
  return load(bytes + 1);
#endif
}

/// Loads the part one row earlier, from bytes just stored part by part: a load across two stores would wait
/// for both.
HWY_INLINE PartVec load_row_before(const std::uint8_t* bytes) {
#if HWY_TARGET == HWY_AVX3
  return PartVec{_mm512_alignr_epi64(load(bytes).raw, load(bytes - kPartBytes).raw, 4)};
#else
  return load(bytes - kRowBytes);
#endif
}

/// Deposits the lowest bits of `bits` at the set bits of `mask`.
HWY_INLINE PartBits deposit_bits(PartBits bits, PartBits mask) {
#if HWY_TARGET == HWY_AVX3
  return _pdep_u64(bits, mask);
#elif HWY_TARGET == HWY_AVX2
  return _pdep_u32(bits, mask);
#else
  PartBits found = 0;
  for (; mask != 0; mask &= mask - 1, bits >>= 1U) {
    if ((bits & 1U) != 0) found |= mask & (~mask + 1);
  }
  return found;
#endif
}

/// Calls visit(i) for each set bit i.
template <class Visit>
HWY_INLINE void over_bits(std::uint64_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// One byte per voxel for the rows of the last four waves, from row y = -2, with room after the last.
class WaveBytes {
 public:
  explicit WaveBytes(std::uint8_t value) {
    for (auto& wave : bytes_) wave.fill(value);
  }

  /// The bytes of row y = 0.
  [[nodiscard]] HWY_INLINE std::uint8_t* of(int wave) {
    return bytes_[static_cast<std::size_t>(wave) % 4].data() + 2 * kRowBytes;
  }

 private:
  alignas(64) std::array<std::array<std::uint8_t, (kChunkSize + 8) * kRowBytes>, 4> bytes_;
};

/// Parts of a wave.
struct WaveParts {
  explicit WaveParts(int wave)
      : first_row{static_cast<std::size_t>(first_row_of(wave))},
        last_row{static_cast<std::size_t>(last_row_of(wave))},
        first{first_row * kRowBytes / kPartBytes},
        last{((last_row + 1) * kRowBytes - 1) / kPartBytes} {}

  [[nodiscard]] std::size_t rows() const { return last_row - first_row + 1; }
  [[nodiscard]] PartSet all() const { return (PartSet{2} << last) - (PartSet{1} << first); }

  /// Mask of the voxels of a part that belong to the wave.
  [[nodiscard]] HWY_INLINE PartBits inside(std::size_t part) const {
    PartBits bits = kAllBits;
    if constexpr (kPartBytes > kRowBytes) {
      if (2 * part < first_row) bits &= static_cast<PartBits>(std::uint64_t{0xFFFFFFFF} << 32U);
      if (2 * part + 1 > last_row) bits &= 0xFFFFFFFF;
    }
    return bits;
  }

  std::size_t first_row;
  std::size_t last_row;
  std::size_t first;
  std::size_t last;
};

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
