#include "volume_pack.h"

#include <bit>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace talus::codec {

#if defined(__x86_64__)
#define TALUS_VBMI2 \
  __attribute__((target("avx512f,avx512bw,avx512vl,avx512dq,avx512vbmi2,gfni,bmi,bmi2,popcnt")))

namespace {

/// Bits to bytes: of each row 32 bytes, a column each, of which bit b is from the masks of bit b.
class RowBytes {
 public:
  TALUS_VBMI2 explicit RowBytes(const std::uint32_t* bits) {
    // The product of bit matrices below takes the rows of eight bytes in reverse: the masks come last first.
    __m512i masks[8];
    for (std::size_t b = 0; b < 8; ++b) masks[7 - b] = _mm512_loadu_si512(bits + b * kPackRows);
    // Bytes of eight columns by bytes of eight columns next to one another.
    __m512i pairs[8];
    for (std::size_t i = 0; i < 4; ++i) {
      pairs[2 * i] = _mm512_unpacklo_epi8(masks[2 * i], masks[2 * i + 1]);
      pairs[2 * i + 1] = _mm512_unpackhi_epi8(masks[2 * i], masks[2 * i + 1]);
    }
    __m512i fours[8];
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t half = 0; half < 2; ++half) {
        const __m512i first = pairs[4 * i + half];
        const __m512i second = pairs[4 * i + 2 + half];
        fours[4 * i + 2 * half] = _mm512_unpacklo_epi16(first, second);
        fours[4 * i + 2 * half + 1] = _mm512_unpackhi_epi16(first, second);
      }
    }
    const __m512i columns = _mm512_set1_epi64(static_cast<long long>(0x8040201008040201ULL));
    // With masks of ones: GCC 12 warns of what the instructions without a mask are made of.
    for (std::size_t k = 0; k < 4; ++k) {
      bytes_[2 * k] = _mm512_gf2p8affine_epi64_epi8(
          columns, _mm512_maskz_unpacklo_epi32(0xFFFF, fours[k], fours[4 + k]), 0);
      bytes_[2 * k + 1] = _mm512_gf2p8affine_epi64_epi8(
          columns, _mm512_maskz_unpackhi_epi32(0xFFFF, fours[k], fours[4 + k]), 0);
    }
  }

  /// Row i lies in lane i / 4 of two vectors.
  [[nodiscard]] TALUS_VBMI2 __m256i row(std::size_t i) const {
    const auto* const half = reinterpret_cast<const __m128i*>(&bytes_[2 * (i % 4)]) + i / 4;
    return _mm256_inserti128_si256(_mm256_castsi128_si256(half[0]), half[4], 1);
  }

 private:
  __m512i bytes_[8];
};

TALUS_VBMI2 std::size_t pack_contexts(const PackedRows& rows, const std::uint32_t* bits, std::uint8_t* out) {
  const RowBytes bytes{bits};
  std::uint8_t* to = out;
  for (std::uint32_t left = rows.coded_rows; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    const __m256i packed = _mm256_maskz_compress_epi8(rows.coded[i], bytes.row(i));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), packed);
    to += std::popcount(rows.coded[i]);
  }
  return static_cast<std::size_t>(to - out);
}

TALUS_VBMI2 void pack_symbols(const PackedRows& rows, const std::uint32_t* low, const std::uint32_t* high,
                              std::uint8_t* out) {
  for (std::uint32_t left = rows.coded_rows; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    const __m256i low_bits = _mm256_maskz_set1_epi8(low[i], 1);
    const __m256i symbols = _mm256_mask_add_epi8(low_bits, high[i], low_bits, _mm256_set1_epi8(2));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_maskz_compress_epi8(rows.coded[i], symbols));
    out += std::popcount(rows.coded[i]);
  }
}

constexpr VolumePack kPack{pack_contexts, pack_symbols};

}  // namespace

const VolumePack* volume_pack() {
  static const bool has_instructions =
      __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
      __builtin_cpu_supports("avx512vbmi2") != 0 && __builtin_cpu_supports("gfni") != 0;
  return has_instructions ? &kPack : nullptr;
}

#else

const VolumePack* volume_pack() {
  return nullptr;
}

#endif

}  // namespace talus::codec
