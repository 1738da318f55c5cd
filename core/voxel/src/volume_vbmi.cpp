#include "volume_vbmi.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "volume_kernels.h"
#include "volume_tables.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace talus::codec {

#if defined(__x86_64__)

namespace {

#define TALUS_VBMI __attribute__((target("avx512f,avx512bw,avx512vbmi,avx512vbmi2,gfni,bmi,bmi2,popcnt")))

TALUS_VBMI std::size_t pack(const std::uint64_t* bits, std::uint64_t columns, const std::uint8_t* bytes,
                            std::size_t parts, std::uint8_t* out) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < parts; ++i) {
    const std::uint64_t which = bits[i] & columns;
    const __m512i part = _mm512_loadu_si512(bytes + 64 * i);
    _mm512_storeu_si512(out + size, _mm512_maskz_compress_epi8(which, part));
    size += static_cast<std::size_t>(std::popcount(which));
  }
  return size;
}

/// Contexts of 64 voxels from eight words, each with one bit of every context.
TALUS_VBMI __m512i contexts_of(__m512i words) {
  // Each byte of a word of eight voxels has one bit of each, highest bit first: a matrix of 8 x 8 bits,
  // multiplied by the eight one-bit bytes.
  alignas(64) static constexpr auto kOrder = [] {
    std::array<std::uint8_t, 64> order{};
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = static_cast<std::uint8_t>(8 * (7 - i % 8) + i / 8);
    return order;
  }();
  const __m512i matrices = _mm512_permutex2var_epi8(words, _mm512_load_si512(kOrder.data()), words);
  return _mm512_gf2p8affine_epi64_epi8(_mm512_set1_epi64(static_cast<long long>(0x8040201008040201U)),
                                       matrices, 0);
}

/// Transposes parts of 16 bytes: part i of the four vectors becomes vector 2 * i.
TALUS_VBMI void transpose_parts(const __m512i* from, __m512i* to) {
  const __m512i a = _mm512_maskz_shuffle_i64x2(0xFF, from[0], from[1], 0x44);
  const __m512i b = _mm512_maskz_shuffle_i64x2(0xFF, from[2], from[3], 0x44);
  const __m512i c = _mm512_maskz_shuffle_i64x2(0xFF, from[0], from[1], 0xEE);
  const __m512i d = _mm512_maskz_shuffle_i64x2(0xFF, from[2], from[3], 0xEE);
  to[0] = _mm512_maskz_shuffle_i64x2(0xFF, a, b, 0x88);
  to[2] = _mm512_maskz_shuffle_i64x2(0xFF, a, b, 0xDD);
  to[4] = _mm512_maskz_shuffle_i64x2(0xFF, c, d, 0x88);
  to[6] = _mm512_maskz_shuffle_i64x2(0xFF, c, d, 0xDD);
}

/// Pairs i of the rows of eight become vector i.
TALUS_VBMI void transpose_pairs(const RowWords* words, __m512i* out) {
  __m512i low[4];
  __m512i high[4];
  for (std::size_t i = 0; i < 4; ++i) {
    const __m512i a = _mm512_load_si512(words[2 * i].data());
    const __m512i b = _mm512_load_si512(words[2 * i + 1].data());
    low[i] = _mm512_maskz_unpacklo_epi64(0xFF, a, b);
    high[i] = _mm512_maskz_unpackhi_epi64(0xFF, a, b);
  }
  transpose_parts(low, out);
  transpose_parts(high, out + 1);
}

/// Stores the first 32 of 64 bytes.
TALUS_VBMI void store_half(std::uint8_t* to, __m512i bytes) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm512_maskz_extracti64x4_epi64(0xF, bytes, 0));
}

TALUS_VBMI CodedHalves pack_wave(const WaveBits& bits, std::size_t pairs, std::uint8_t* contexts,
                                 std::uint8_t* symbols) {
  constexpr std::uint64_t kEven = 0x5555555555555555U;
  const auto word = [](const RowWords& words, std::size_t pair) {
    std::uint64_t both;
    std::memcpy(&both, words.data() + 2 * pair, sizeof both);
    return both;
  };
  __m512i words[8];
  transpose_pairs(bits.context.data(), words);
  // Odd columns are buffered until the number of even ones before them is known.
  alignas(64) std::array<std::uint8_t, kMaxBatch + 64> odd_contexts;
  alignas(64) std::array<std::uint8_t, kMaxBatch + 64> odd_symbols;
  CodedHalves sizes{0, 0};
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    const std::uint64_t coded = word(bits.coded, pair);
    const std::uint64_t even = coded & kEven;
    const std::uint64_t odd = coded & ~kEven;
    const __m512i context = contexts_of(words[pair]);
    const __m512i low = _mm512_maskz_mov_epi8(word(bits.symbol[0], pair), _mm512_set1_epi8(1));
    const __m512i symbol = _mm512_mask_add_epi8(low, word(bits.symbol[1], pair), low, _mm512_set1_epi8(2));
    store_half(contexts + sizes.even, _mm512_maskz_compress_epi8(even, context));
    store_half(symbols + sizes.even, _mm512_maskz_compress_epi8(even, symbol));
    store_half(odd_contexts.data() + sizes.odd, _mm512_maskz_compress_epi8(odd, context));
    store_half(odd_symbols.data() + sizes.odd, _mm512_maskz_compress_epi8(odd, symbol));
    sizes.even += static_cast<std::size_t>(std::popcount(even));
    sizes.odd += static_cast<std::size_t>(std::popcount(odd));
  }
  for (std::size_t at = 0; at < sizes.odd; at += 64) {
    _mm512_storeu_si512(contexts + sizes.even + at, _mm512_load_si512(odd_contexts.data() + at));
    _mm512_storeu_si512(symbols + sizes.even + at, _mm512_load_si512(odd_symbols.data() + at));
  }
  return sizes;
}

/// Looks up `index` in a table of 256 bytes.
TALUS_VBMI __m512i look_up(const __m512i* table, __m512i index) {
  return _mm512_mask_blend_epi8(_mm512_movepi8_mask(index),
                                _mm512_permutex2var_epi8(table[0], index, table[1]),
                                _mm512_permutex2var_epi8(table[2], index, table[3]));
}

TALUS_VBMI Numbering number(const std::uint16_t* ids, VoxelRows& rows, MaterialCode& materials) {
  // By low byte: the high byte of the last material with it. A voxel with another high byte is of a new
  // material, or of one that shares its low byte. An equal high byte of kNone proves nothing: kNone fills the
  // table initially.
  constexpr std::uint8_t kNone = 0xFF;
  constexpr std::size_t kAhead = 2048;  // voxels
  alignas(64) std::array<std::uint8_t, 256> high_of;
  alignas(64) std::array<std::uint8_t, 256> is_taken{};  // by low byte: 0xFF if a material has it
  high_of.fill(kNone);
  bool differ = true;  // all materials have different low bytes
  alignas(64) static constexpr auto kEven = [] {
    std::array<std::uint8_t, 64> places{};
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<std::uint8_t>(2 * i);
    return places;
  }();
  const __m512i even = _mm512_load_si512(kEven.data());
  const __m512i odd = _mm512_add_epi8(even, _mm512_set1_epi8(1));
  const __m512i none = _mm512_set1_epi8(static_cast<char>(kNone));
  __m512i table[4] = {none, none, none, none};
  for (std::size_t i = 0; i < kChunkVolume; i += 64) {
    // The voxels are seldom in a near cache: prefetch them.
    const std::uint16_t* const ahead = ids + std::min(i + kAhead, std::size_t{kChunkVolume} - 64);
    _mm_prefetch(reinterpret_cast<const char*>(ahead), _MM_HINT_T0);
    _mm_prefetch(reinterpret_cast<const char*>(ahead + 32), _MM_HINT_T0);
    const __m512i first = _mm512_loadu_si512(ids + i);
    const __m512i second = _mm512_loadu_si512(ids + i + 32);
    const __m512i low = _mm512_permutex2var_epi8(first, even, second);
    const __m512i high = _mm512_permutex2var_epi8(first, odd, second);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(rows.row(i / 32)),
                        _mm512_maskz_extracti64x4_epi64(0xF, low, 0));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(rows.row(i / 32 + 1)),
                        _mm512_maskz_extracti64x4_epi64(0xF, low, 1));
    const __m512i found = look_up(table, low);
    std::uint64_t unknown = _mm512_cmpneq_epi8_mask(found, high);
    if (const std::uint64_t unsure = _mm512_cmpeq_epi8_mask(high, none); unsure != 0) {
      __m512i taken[4];
      for (std::size_t t = 0; t < 4; ++t) taken[t] = _mm512_load_si512(is_taken.data() + 64 * t);
      unknown |= unsure & ~_mm512_movepi8_mask(look_up(taken, low));
    }
    if (unknown == 0) continue;
    for (; unknown != 0; unknown &= unknown - 1) {
      const std::uint16_t id = ids[i + static_cast<std::size_t>(std::countr_zero(unknown))];
      const std::size_t place = id & 0xFFU;
      const auto top = static_cast<std::uint8_t>(id >> 8U);
      if (is_taken[place] != 0 && high_of[place] == top)
        continue;  // an earlier voxel of this vector added it
      differ &= is_taken[place] == 0;
      is_taken[place] = 0xFF;
      high_of[place] = top;
      if (materials.number_of(MaterialId{id}) == MaterialCode::kMaxMaterials) return Numbering::too_many;
    }
    for (std::size_t t = 0; t < 4; ++t) table[t] = _mm512_load_si512(high_of.data() + 64 * t);
  }
  return differ ? Numbering::done : Numbering::two_alike;
}

TALUS_VBMI void intervals(const std::uint8_t* ends, bool odd, const std::uint8_t* contexts,
                          const std::uint8_t* symbols, std::size_t count, std::uint8_t* starts,
                          std::uint8_t* sizes) {
  // By symbol and class: end of the interval.
  alignas(64) static constexpr auto kEnds = [] {
    std::array<std::array<std::uint8_t, 64>, 3> by_symbol{};
    static_assert(kVolumeEnds.size() <= 64);
    for (std::size_t i = 0; i < kVolumeEnds.size(); ++i) {
      for (std::size_t symbol = 0; symbol < 3; ++symbol) by_symbol[symbol][i] = kVolumeEnds[i][symbol];
    }
    return by_symbol;
  }();
  __m512i by_symbol[3];
  for (std::size_t s = 0; s < 3; ++s) by_symbol[s] = _mm512_load_si512(kEnds[s].data());
  __m512i by_context[4];
  for (std::size_t t = 0; t < 4; ++t)
    by_context[t] = _mm512_loadu_si512(ends + (odd ? 64 * t : 64 * (t % 2)));
  for (std::size_t at = 0; at < count; at += 64) {
    const __m512i which = look_up(by_context, _mm512_loadu_si512(contexts + at));
    // Looks up two equal tables: with one, gcc 12 warns of an uninitialised variable.
    const __m512i first = _mm512_permutex2var_epi8(by_symbol[0], which, by_symbol[0]);
    const __m512i second = _mm512_permutex2var_epi8(by_symbol[1], which, by_symbol[1]);
    const __m512i third = _mm512_permutex2var_epi8(by_symbol[2], which, by_symbol[2]);
    const __m512i symbol = _mm512_loadu_si512(symbols + at);
    const __mmask64 is_odd = _mm512_test_epi8_mask(symbol, _mm512_set1_epi8(1));
    const __mmask64 is_high = _mm512_test_epi8_mask(symbol, _mm512_set1_epi8(2));
    const __m512i start = _mm512_mask_blend_epi8(is_high, _mm512_maskz_mov_epi8(is_odd, first),
                                                 _mm512_mask_blend_epi8(is_odd, second, third));
    // Symbol 3 ends at 256, which is 0 as a byte; no symbol spans the whole range.
    const __m512i end = _mm512_mask_blend_epi8(is_high, _mm512_mask_blend_epi8(is_odd, first, second),
                                               _mm512_maskz_mov_epi8(~is_odd, third));
    const __mmask64 coded =
        _bzhi_u64(~std::uint64_t{0}, static_cast<unsigned>(std::min<std::size_t>(count - at, 64)));
    _mm512_storeu_si512(starts + at, _mm512_maskz_mov_epi8(coded, start));
    _mm512_storeu_si512(sizes + at, _mm512_maskz_sub_epi8(coded, end, start));
  }
}

#undef TALUS_VBMI

}  // namespace

const VolumeVbmi* volume_vbmi() {
  static constexpr VolumeVbmi kVbmi{pack, pack_wave, number, intervals};
  static const bool has_instructions =
      __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vbmi") != 0 &&
      __builtin_cpu_supports("avx512vbmi2") != 0 && __builtin_cpu_supports("gfni") != 0;
  return has_instructions ? &kVbmi : nullptr;
}

#else

const VolumeVbmi* volume_vbmi() {
  return nullptr;
}

#endif

}  // namespace talus::codec
