#include "volume_pack.h"

#include <bit>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace talus::codec {

#if defined(__x86_64__)

namespace {

__attribute__((target("avx512f,avx512bw,avx512vbmi2,bmi,bmi2,popcnt"))) std::size_t pack(
    const std::uint64_t* coded, const std::uint8_t* bytes, std::size_t parts, std::uint8_t* out) {
  std::uint8_t* to = out;
  for (std::size_t i = 0; i < parts; ++i) {
    const __m512i part = _mm512_loadu_si512(bytes + 64 * i);
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi8(coded[i], part));
    to += std::popcount(coded[i]);
  }
  return static_cast<std::size_t>(to - out);
}

}  // namespace

VolumePack volume_pack() {
  static const bool has_instruction =
      __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vbmi2") != 0;
  return has_instruction ? pack : nullptr;
}

#else

VolumePack volume_pack() {
  return nullptr;
}

#endif

}  // namespace talus::codec
