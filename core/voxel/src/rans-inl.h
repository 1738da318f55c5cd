// Vectors of 16 lanes for rANS. Included once per instruction set, hence this guard:
#if defined(TALUS_RANS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_RANS_INL
#undef TALUS_RANS_INL
#else
#define TALUS_RANS_INL
#endif

#include <bit>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "rans.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

using namespace codec;
namespace hn = hwy::HWY_NAMESPACE;

// One byte per lane.
using Half = hn::FixedTag<std::uint8_t, kLanes>;
using HalfRows = hn::RebindToSigned<Half>;
using HalfVec = hn::Vec<Half>;

// One byte per lane, held twice if vectors are wide enough.
using Bytes = hn::CappedTag<std::uint8_t, 2 * kLanes>;
using ByteVec = hn::Vec<Bytes>;

// The states, one per lane, in one vector or two.
using Words = hn::CappedTag<std::uint16_t, kLanes>;
using SignedWords = hn::RebindToSigned<Words>;
using WordVec = hn::Vec<Words>;
#undef TALUS_TWICE
#define TALUS_TWICE (HWY_MAX_BYTES >= 32)
constexpr std::size_t kParts = TALUS_TWICE ? 1 : 2;
struct WordParts {
  WordVec part[kParts];
};

HWY_INLINE WordParts load_words(const std::uint16_t* words) {
  const Words d;
  WordParts parts;
  for (std::size_t p = 0; p < kParts; ++p) parts.part[p] = hn::LoadU(d, words + p * hn::MaxLanes(d));
  return parts;
}

HWY_INLINE void store_words(const WordParts& parts, std::uint16_t* words) {
  const Words d;
  for (std::size_t p = 0; p < kParts; ++p) hn::StoreU(parts.part[p], d, words + p * hn::MaxLanes(d));
}

HWY_INLINE HalfVec lower_half(ByteVec v) {
#if TALUS_TWICE
  return hn::LowerHalf(Half{}, v);
#else
  return v;
#endif
}

HWY_INLINE WordParts widen(HalfVec bytes) {
  const Words d;
  WordParts words;
#if TALUS_TWICE
  words.part[0] = hn::PromoteTo(d, bytes);
#else
  const hn::Half<Half> half;
  words.part[0] = hn::PromoteTo(d, hn::LowerHalf(half, bytes));
  words.part[1] = hn::PromoteTo(d, hn::UpperHalf(half, bytes));
#endif
  return words;
}

/// Narrows words that are below 256 or all ones.
HWY_INLINE HalfVec narrow(const WordParts& words) {
  const Bytes d;
  return lower_half(hn::ConcatEven(d, hn::BitCast(d, words.part[kParts - 1]), hn::BitCast(d, words.part[0])));
}

/// Narrows words that are below 128 or all ones; faster.
HWY_INLINE HalfVec narrow_small(const WordParts& words) {
#if TALUS_TWICE
  return hn::BitCast(Half{}, hn::DemoteTo(HalfRows{}, hn::BitCast(SignedWords{}, words.part[0])));
#else
  return narrow(words);
#endif
}

/// Bit i is lane i.
HWY_INLINE std::uint32_t lanes_of(hn::Mask<Half> mask) {
#if HWY_TARGET == HWY_AVX3
  return mask.raw;
#elif HWY_TARGET == HWY_AVX2
  return static_cast<std::uint32_t>(_mm_movemask_epi8(mask.raw));
#else
  std::uint8_t bits[8] = {};  // StoreMaskBits may write eight
  hn::StoreMaskBits(Half{}, mask, bits);
  return bits[0] | std::uint32_t{bits[1]} << 8U;
#endif
}

/// Starts of the intervals of symbols 1, 2 and 3, by lane. All 0: the lane has no symbol, and its state stays
/// unchanged.
struct StartParts {
  WordParts one;
  WordParts two;
  WordParts three;
};

/// Appends a byte to each state below kMinState, in lane order.
HWY_INLINE void refill(WordParts& states, const std::uint8_t*& next) {
  const Words words;
#if HWY_TARGET == HWY_AVX3
  // One instruction distributes the bytes to the lanes.
  auto& state = states.part[0];
  const auto takes = hn::Lt(state, hn::Set(words, kMinState));
  const __m512i bytes = _mm512_cvtepu8_epi32(hn::LoadU(Half{}, next).raw);
  const WordVec more{_mm512_cvtepi32_epi16(_mm512_maskz_expand_epi32(takes.raw, bytes))};
  state = hn::Or(hn::IfThenElse(takes, hn::ShiftLeft<8>(state), state), more);
  next += std::popcount(static_cast<std::uint16_t>(takes.raw));
#else
  const SignedWords compared;
  const Half d;
  WordParts takes;
  for (std::size_t p = 0; p < kParts; ++p) {
    // A signed comparison of the state itself would be wrong.
    const auto high = hn::BitCast(compared, hn::ShiftRight<8>(states.part[p]));
    takes.part[p] = hn::BitCast(words, hn::VecFromMask(compared, hn::Eq(high, hn::Zero(compared))));
  }
  const HalfVec taking = narrow_small(takes);  // -1 in lanes that take a byte
  // Negative number of such lanes up to each lane.
  HalfVec sum = taking;
  sum = hn::Add(sum, hn::ShiftLeftBytes<1>(d, sum));
  sum = hn::Add(sum, hn::ShiftLeftBytes<2>(d, sum));
  sum = hn::Add(sum, hn::ShiftLeftBytes<4>(d, sum));
  sum = hn::Add(sum, hn::ShiftLeftBytes<8>(d, sum));
  const HalfVec place = hn::Or(hn::Not(sum), hn::Not(taking));
  const WordParts more = widen(hn::TableLookupBytesOr0(hn::LoadU(d, next), place));
  next += static_cast<std::uint8_t>(-static_cast<std::int8_t>(hn::ExtractLane(sum, kLanes - 1)));
  for (std::size_t p = 0; p < kParts; ++p) {
    const auto mask = hn::MaskFromVec(takes.part[p]);
    states.part[p] =
        hn::Or(hn::IfThenElse(mask, hn::ShiftLeft<8>(states.part[p]), states.part[p]), more.part[p]);
  }
#endif
}

/// For words below 32768.
HWY_INLINE WordVec all_ones_where_less(WordVec a, WordVec b) {
#if HWY_TARGET == HWY_AVX3
  // Avoids a mask register, which takes six times as long.
  return WordVec{_mm256_cmpgt_epi16(b.raw, a.raw)};
#else
  const SignedWords d;
  return hn::BitCast(Words{}, hn::VecFromMask(d, hn::Lt(hn::BitCast(d, a), hn::BitCast(d, b))));
#endif
}

/// Returns the symbol of each lane, 0 to 3.
HWY_INLINE HalfVec decode_symbols(WordParts& states, const StartParts& starts, const std::uint8_t*& next) {
  const Words d;
  WordParts symbols;
  for (std::size_t p = 0; p < kParts; ++p) {
    const auto state = states.part[p];
    const auto slot = hn::And(state, hn::Set(d, kProbabilityTotal - 1));
    // True if the slot lies before the start of a symbol's interval. No start exceeds 256.
    const auto is_before = [&](WordVec start) HWY_ATTR { return all_ones_where_less(slot, start); };
    const auto one = starts.one.part[p];
    const auto two = starts.two.part[p];
    const auto three = starts.three.part[p];
    const auto before_one = is_before(one);
    const auto before_two = is_before(two);
    const auto before_three = is_before(three);
    // Greatest start not above the slot, and least start above it.
    const auto start = hn::Max(hn::AndNot(before_one, one),
                               hn::Max(hn::AndNot(before_two, two), hn::AndNot(before_three, three)));
    const auto end = hn::Min(hn::Min(hn::Or(hn::Not(before_one), one), hn::Or(hn::Not(before_two), two)),
                             hn::Min(hn::Or(hn::Not(before_three), three), hn::Set(d, kProbabilityTotal)));
    states.part[p] = hn::Add(hn::Mul(hn::Sub(end, start), hn::ShiftRight<8>(state)), hn::Sub(slot, start));
    symbols.part[p] =
        hn::Add(hn::Add(hn::Set(d, std::uint16_t{3}), before_one), hn::Add(before_two, before_three));
  }
  const HalfVec taken = narrow_small(symbols);
  refill(states, next);
  return taken;
}

/// 65536 / size, rounded down and at most 65535, for sizes 1 to 256. 24-bit floats are exact enough: no
/// quotient is nearer than 1 / 256 to the next integer.
HWY_INLINE WordVec reciprocals(WordVec sizes) {
#if HWY_TARGET == HWY_AVX3
  const __m512 divisor = _mm512_cvtepi32_ps(_mm512_cvtepu16_epi32(sizes.raw));
  return WordVec{
      _mm512_cvtusepi32_epi16(_mm512_cvttps_epi32(_mm512_div_ps(_mm512_set1_ps(65536.0F), divisor)))};
#else
  const hn::Half<Words> half;
  const hn::Repartition<float, Words> floats;
  const hn::Repartition<std::int32_t, Words> integers;
  const auto part = [&](auto x) HWY_ATTR {
    const auto divisor = hn::ConvertTo(floats, hn::PromoteTo(integers, x));
    return hn::DemoteTo(half, hn::ConvertTo(integers, hn::Div(hn::Set(floats, 65536.0F), divisor)));
  };
  return hn::Combine(Words{}, part(hn::UpperHalf(half, sizes)), part(hn::LowerHalf(half, sizes)));
#endif
}

/// By mask of eight lanes: source of each of eight bytes, so that the selected bytes come last.
inline constexpr auto kLastBytes = [] {
  std::array<std::array<std::uint8_t, 8>, 256> table{};
  for (std::size_t mask = 0; mask < 256; ++mask) {
    std::size_t place = 8;
    for (std::uint8_t lane = 8; lane-- > 0;) {
      if ((mask >> lane & 1U) != 0) table[mask][--place] = lane;
    }
  }
  return table;
}();

/// Writes one symbol per lane. The interval from 0 to 256 leaves a lane unchanged.
HWY_INLINE void encode_symbols(WordParts& states, const WordParts& starts, const WordParts& sizes,
                               std::uint8_t*& next) {
  const Words d;
  WordParts low;
  WordParts fits;
  for (std::size_t p = 0; p < kParts; ++p) {
    const auto state = states.part[p];
    const auto size = sizes.part[p];
    // Values independent of the states come first: the chain from state to state bounds the speed.
    const auto reciprocal = reciprocals(size);
    const auto beyond = hn::Sub(hn::Set(d, kProbabilityTotal), size);
    const auto next_start = hn::Add(starts.part[p], beyond);
    // Checks whether the state would exceed 16 bits. High bytes and sizes are at most 256.
    const auto high = hn::ShiftRight<8>(state);
    fits.part[p] = all_ones_where_less(high, size);
    low.part[p] = hn::And(state, hn::Set(d, kProbabilityTotal - 1));
    const auto left = hn::IfVecThenElse(fits.part[p], state, high);
    // The quotient left / size, or one less: the reciprocal is at most 1 too small, and left is below 65536.
    const auto quotient = hn::MulHigh(left, reciprocal);
    const auto rest = hn::Sub(left, hn::Mul(quotient, size));
    const auto first = hn::And(all_ones_where_less(rest, size), beyond);
    // quotient * 256 + rest is left + quotient * (256 - size).
    states.part[p] = hn::Sub(hn::Add(hn::Add(left, next_start), hn::Mul(quotient, beyond)), first);
  }
#if HWY_TARGET == HWY_AVX3
  // Without a branch: which lanes are full is unpredictable.
  const auto lanes = static_cast<__mmask16>(~_mm256_movepi16_mask(fits.part[0].raw));
  const int count = std::popcount(static_cast<std::uint16_t>(lanes));
  const __m512i bytes = _mm512_maskz_compress_epi32(lanes, _mm512_cvtepu16_epi32(low.part[0].raw));
  next -= count;
  _mm_mask_storeu_epi8(next, static_cast<__mmask16>((1U << count) - 1), _mm512_cvtepi32_epi8(bytes));
#else
  // Moves the bytes of eight lanes to the end of eight bytes. The bytes before them are overwritten by lower
  // lanes, or lie before `next`.
  const std::uint32_t lanes = lanes_of(hn::Not(hn::MaskFromVec(narrow_small(fits))));
  const hn::FixedTag<std::uint8_t, 8> eight;
  const HalfVec bytes = narrow(low);
  const auto put = [&](auto from, std::uint32_t which) HWY_ATTR {
    const auto order = hn::LoadU(eight, kLastBytes[which].data());
    hn::StoreU(hn::TableLookupBytes(from, order), eight, next - 8);
    next -= std::popcount(which);
  };
  put(hn::UpperHalf(eight, bytes), lanes >> 8U);
  put(hn::LowerHalf(eight, bytes), lanes & 0xFFU);
#endif
}

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
