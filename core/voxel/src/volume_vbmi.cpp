#include "volume_vbmi.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "volume_tables.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace talus::codec {

#if defined(__x86_64__)

namespace {

#define TALUS_VBMI __attribute__((target("avx512f,avx512bw,avx512vbmi,avx512vbmi2,bmi,bmi2,popcnt")))

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

TALUS_VBMI std::size_t pack_two(const std::uint64_t* bits, std::uint64_t columns, const std::uint8_t* bytes,
                                const std::uint8_t* more, std::size_t parts, std::uint8_t* out,
                                std::uint8_t* more_out) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < parts; ++i) {
    const std::uint64_t which = bits[i] & columns;
    const __m512i part = _mm512_loadu_si512(bytes + 64 * i);
    const __m512i another = _mm512_loadu_si512(more + 64 * i);
    _mm512_storeu_si512(out + size, _mm512_maskz_compress_epi8(which, part));
    _mm512_storeu_si512(more_out + size, _mm512_maskz_compress_epi8(which, another));
    size += static_cast<std::size_t>(std::popcount(which));
  }
  return size;
}

/// Of 256 bytes, those that `index` names.
TALUS_VBMI __m512i look_up(const __m512i* table, __m512i index) {
  return _mm512_mask_blend_epi8(_mm512_movepi8_mask(index),
                                _mm512_permutex2var_epi8(table[0], index, table[1]),
                                _mm512_permutex2var_epi8(table[2], index, table[3]));
}

TALUS_VBMI Numbering number(const std::uint16_t* ids, std::uint8_t* numbers, MaterialCode& materials) {
  // By low byte: the high byte of the material that had it last. A voxel with another high byte is of a new
  // material, or of one that shares its low byte. An equal high byte of kNone proves nothing: kNone fills the
  // table at first.
  constexpr std::uint8_t kNone = 0xFF;
  constexpr std::size_t kAhead = 2048;  // voxels
  alignas(64) std::array<std::uint8_t, 256> high_of;
  alignas(64) std::array<std::uint8_t, 256> is_taken{};  // by low byte: 0xFF where a material has it
  high_of.fill(kNone);
  bool differ = true;  // no two materials have one low byte
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
    // The voxels seldom lie in a near cache: ask for them early.
    const std::uint16_t* const ahead = ids + std::min(i + kAhead, std::size_t{kChunkVolume} - 64);
    _mm_prefetch(reinterpret_cast<const char*>(ahead), _MM_HINT_T0);
    _mm_prefetch(reinterpret_cast<const char*>(ahead + 32), _MM_HINT_T0);
    const __m512i first = _mm512_loadu_si512(ids + i);
    const __m512i second = _mm512_loadu_si512(ids + i + 32);
    const __m512i low = _mm512_permutex2var_epi8(first, even, second);
    const __m512i high = _mm512_permutex2var_epi8(first, odd, second);
    _mm512_storeu_si512(numbers + i, low);
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
  // By symbol, where its intervals end: of each class.
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
    // Of two tables that are the same: of one, gcc 12 warns of a variable that is not initialised.
    const __m512i first = _mm512_permutex2var_epi8(by_symbol[0], which, by_symbol[0]);
    const __m512i second = _mm512_permutex2var_epi8(by_symbol[1], which, by_symbol[1]);
    const __m512i third = _mm512_permutex2var_epi8(by_symbol[2], which, by_symbol[2]);
    const __m512i symbol = _mm512_loadu_si512(symbols + at);
    const __mmask64 is_odd = _mm512_test_epi8_mask(symbol, _mm512_set1_epi8(1));
    const __mmask64 is_high = _mm512_test_epi8_mask(symbol, _mm512_set1_epi8(2));
    const __m512i start = _mm512_mask_blend_epi8(is_high, _mm512_maskz_mov_epi8(is_odd, first),
                                                 _mm512_mask_blend_epi8(is_odd, second, third));
    // Symbol 3 ends at 256, which is 0 in a byte; no symbol has all of it.
    const __m512i end = _mm512_mask_blend_epi8(is_high, _mm512_mask_blend_epi8(is_odd, first, second),
                                               _mm512_maskz_mov_epi8(~is_odd, third));
    _mm512_storeu_si512(starts + at, start);
    _mm512_storeu_si512(sizes + at, _mm512_sub_epi8(end, start));
  }
}

#undef TALUS_VBMI

}  // namespace

const VolumeVbmi* volume_vbmi() {
  static constexpr VolumeVbmi kVbmi{pack, pack_two, number, intervals};
  static const bool has_instructions = __builtin_cpu_supports("avx512bw") != 0 &&
                                       __builtin_cpu_supports("avx512vbmi") != 0 &&
                                       __builtin_cpu_supports("avx512vbmi2") != 0;
  return has_instructions ? &kVbmi : nullptr;
}

#else

const VolumeVbmi* volume_vbmi() {
  return nullptr;
}

#endif

}  // namespace talus::codec
