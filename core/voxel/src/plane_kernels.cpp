#include "plane_kernels.h"

#include <talus/vectors/tables.h>

#include "plane_plain.h"
#include "plane_weights.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plane_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

using namespace codec;

#if HWY_TARGET == HWY_SCALAR

PlaneFault read(PlaneSource& source, const std::uint8_t* below, std::uint8_t* plane) {
  return read_plane_plainly(source, below, plane);
}

void weigh(const std::uint8_t* plane, const std::uint8_t* below, PlaneShares& shares) {
  weigh_plane_plainly(plane, below, shares);
}

void write(const PlaneShares& shares, PlaneSink& sink) {
  write_plane_plainly(shares, sink);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

// Half a row, its even or its odd columns, is a vector of sixteen bytes. Rows are 0 to 32, so that bytes with
// a sign hold them.
using Half = hn::FixedTag<std::uint8_t, kLanes>;
using HalfRows = hn::RebindToSigned<Half>;
using HalfVec = hn::Vec<Half>;
using RowVec = hn::Vec<HalfRows>;

// Where vectors have room for it, a half twice: both scores are looked up at once.
using Bytes = hn::CappedTag<std::uint8_t, 2 * kLanes>;
using Rows = hn::RebindToSigned<Bytes>;
using ByteVec = hn::Vec<Bytes>;
using ScoreVec = hn::Vec<Rows>;

// The states, one to each lane of a half: one vector, or two.
using Words = hn::CappedTag<std::uint16_t, kLanes>;
using SignedWords = hn::RebindToSigned<Words>;
using WordVec = hn::Vec<Words>;
#undef TALUS_TWICE
#define TALUS_TWICE (HWY_MAX_BYTES >= 32)
constexpr std::size_t kParts = TALUS_TWICE ? 1 : 2;
struct WordParts {
  WordVec part[kParts];
};

/// A row's columns.
struct RowHalves {
  RowVec even;
  RowVec odd;
};
struct SignHalves {
  HalfVec even;
  HalfVec odd;
};

HWY_INLINE RowHalves load_row(const std::uint8_t* row) {
  const Half d;
  const HalfRows rows;
  const auto low = hn::LoadU(d, row);
  const auto high = hn::LoadU(d, row + kLanes);
  return {hn::BitCast(rows, hn::ConcatEven(d, high, low)), hn::BitCast(rows, hn::ConcatOdd(d, high, low))};
}

HWY_INLINE void store_row(RowHalves row, std::uint8_t* out) {
  const HalfRows d;
  hn::StoreU(hn::BitCast(Half{}, hn::InterleaveLower(d, row.even, row.odd)), Half{}, out);
  hn::StoreU(hn::BitCast(Half{}, hn::InterleaveUpper(d, row.even, row.odd)), Half{}, out + kLanes);
}

/// What lies in the lane before, `first` in the first.
template <class Vec>
HWY_INLINE Vec before(Vec v, Vec first) {
  const Half d;
  return hn::BitCast(hn::DFromV<Vec>{},
                     hn::CombineShiftRightBytes<kLanes - 1>(d, hn::BitCast(d, v), hn::BitCast(d, first)));
}

/// What lies in the lane after, `last` in the last.
template <class Vec>
HWY_INLINE Vec after(Vec v, Vec last) {
  const Half d;
  return hn::BitCast(hn::DFromV<Vec>{},
                     hn::CombineShiftRightBytes<1>(d, hn::BitCast(d, last), hn::BitCast(d, v)));
}

template <class Vec>
HWY_INLINE Vec first_everywhere(Vec v) {
  return hn::TableLookupBytes(v, hn::Zero(hn::DFromV<Vec>{}));
}

template <class Vec>
HWY_INLINE Vec last_everywhere(Vec v) {
  const hn::DFromV<Vec> d;
  return hn::TableLookupBytes(v, hn::Set(d, static_cast<hn::TFromD<decltype(d)> >(kLanes - 1)));
}

/// 0, 1 or 2 for a below, equal to or above b.
HWY_INLINE HalfVec sign(RowVec a, RowVec b) {
  const HalfRows d;
  const auto above = hn::VecFromMask(d, hn::Gt(a, b));  // -1 where true
  const auto under = hn::VecFromMask(d, hn::Lt(a, b));
  return hn::BitCast(Half{}, hn::Add(hn::Sub(hn::Set(d, 1), above), under));
}

/// Times four, of bytes below 64.
HWY_INLINE HalfVec times_four(HalfVec v) {
  const hn::Repartition<std::uint16_t, Half> words;
  return hn::BitCast(Half{}, hn::ShiftLeft<2>(hn::BitCast(words, v)));
}

HWY_INLINE ByteVec twice(HalfVec v) {
#if TALUS_TWICE
  return hn::Combine(Bytes{}, v, v);
#else
  return v;
#endif
}

HWY_INLINE HalfVec once(ByteVec v) {
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

/// Of words that are below 256, or all ones.
HWY_INLINE HalfVec narrow(const WordParts& words) {
  const Bytes d;
  return once(hn::ConcatEven(d, hn::BitCast(d, words.part[kParts - 1]), hn::BitCast(d, words.part[0])));
}

/// Of words that are below 128, or all ones: sooner.
HWY_INLINE HalfVec narrow_small(const WordParts& words) {
#if TALUS_TWICE
  return hn::BitCast(Half{}, hn::DemoteTo(HalfRows{}, hn::BitCast(SignedWords{}, words.part[0])));
#else
  return narrow(words);
#endif
}

struct OddsParts {
  WordParts up;
  WordParts down;
  WordParts other;
};

/// A half's scores. Weights are added in the order of kPairs.
class Scores {
 public:
  HWY_INLINE void clear() {
    both_ = hn::Zero(Rows{});
#if !TALUS_TWICE
    up_ = hn::Zero(Rows{});
#endif
  }

  /// `place`: of the pair, by lane.
  HWY_INLINE void add(const PairWeights& weights, HalfVec place) {
    const Rows d;
    const auto at = hn::BitCast(d, twice(place));
    both_ = hn::SaturatedAdd(both_, hn::TableLookupBytes(hn::LoadU(d, weights.same.data()), at));
#if TALUS_TWICE
    static_assert(sizeof(PairWeights) == 2 * kLanes);  // both tables at once
#else
    up_ = hn::SaturatedAdd(up_, hn::TableLookupBytes(hn::LoadU(d, weights.up.data()), at));
#endif
  }

  [[nodiscard]] HWY_INLINE OddsParts odds() const {
    const Bytes d;
    const Words words;
    const auto classes = class_of(both_);
    const auto other = hn::TableLookupBytes(hn::LoadDup128(d, kOtherStart.data()), classes);
#if TALUS_TWICE
    const auto both = hn::TableLookupBytes(hn::LoadU(d, kEndAndShare.data()), classes);
    OddsParts odds{widen(once(both)), {}, widen(once(other))};
    const WordParts share{{hn::PromoteTo(words, hn::UpperHalf(Half{}, both))}};
#else
    const auto end = hn::TableLookupBytes(hn::LoadU(d, kSameEnd.data()), classes);
    OddsParts odds{widen(end), {}, widen(once(other))};
    const WordParts share = widen(hn::TableLookupBytes(hn::LoadU(d, kUpShare.data()), class_of(up_)));
#endif
    for (std::size_t p = 0; p < kParts; ++p) {
      const auto end = odds.up.part[p];
      // One is kUp's in any case, and one kDown's.
      const auto first = hn::Add(end, hn::Set(words, 1));
      const auto between = hn::Sub(hn::Sub(odds.other.part[p], first), hn::Set(words, 1));
      odds.down.part[p] = hn::Add(first, hn::ShiftRight<8>(hn::Mul(between, share.part[p])));
    }
    return odds;
  }

 private:
  static HWY_INLINE ByteVec class_of(ScoreVec score) {
    static_assert(kClasses == 16);
    const Bytes d;
    const hn::Repartition<std::uint16_t, Bytes> words;
    const auto positive = hn::BitCast(words, hn::Max(score, hn::Zero(Rows{})));
    // Bytes below 128: what comes over from the byte above is masked.
    return hn::And(hn::BitCast(d, hn::ShiftRight<3>(positive)), hn::Set(d, 15));
  }

#if TALUS_TWICE
  static constexpr auto kEndAndShare = [] {
    std::array<std::uint8_t, 2 * kClasses> both{};
    for (std::size_t c = 0; c < kClasses; ++c) {
      both[c] = kSameEnd[c];
      both[kClasses + c] = kUpShare[c];
    }
    return both;
  }();
#else
  ScoreVec up_;
#endif
  ScoreVec both_;  // of kSame, and where vectors hold the lanes twice, of kUp
};

/// What is known of a row before it is read.
struct Known {
  RowHalves north;
  RowHalves steps_north;
  RowHalves floor;
  RowHalves floor_north;
};

/// What an odd column's scores still wait for its neighbours with.
struct OddScores {
  Scores scores;
  HalfVec west;
  HalfVec east;
  HalfVec thickness;
};

/// The scores of the even columns, and of the odd ones but for their neighbours' part.
HWY_INLINE void score(const Known& known, const std::array<Weights, 2>& weights, Scores& even,
                      OddScores& odd) {
  const Half d;
  const HalfRows rows;
  const auto& north = known.north;
  even.clear();
  odd.scores.clear();
  std::size_t pair = 0;
  const auto add = [&](SignHalves first, SignHalves second_times_four) HWY_ATTR {
    even.add(weights[0][pair], hn::Or(first.even, second_times_four.even));
    odd.scores.add(weights[1][pair], hn::Or(first.odd, second_times_four.odd));
    ++pair;
  };
  const auto four = [](SignHalves v) HWY_ATTR { return SignHalves{times_four(v.even), times_four(v.odd)}; };

  const auto level = hn::Set(d, 1);
  const auto zero = hn::Zero(rows);
  const SignHalves step{sign(known.steps_north.even, zero), sign(known.steps_north.odd, zero)};
  const SignHalves step_west{before(step.odd, level), step.even};
  const SignHalves step_east{step.odd, after(step.even, level)};
  const SignHalves step_far_west{before(step.even, level), before(step.odd, level)};
  const SignHalves step_far_east{after(step.even, level), after(step.odd, level)};
  const SignHalves floor{sign(known.floor.even, known.floor_north.even),
                         sign(known.floor.odd, known.floor_north.odd)};
  const auto two = hn::Set(rows, 2);
  const SignHalves thickness{hn::BitCast(d, hn::Min(hn::Sub(north.even, known.floor_north.even), two)),
                             hn::BitCast(d, hn::Min(hn::Sub(north.odd, known.floor_north.odd), two))};
  const SignHalves thickness_west{before(thickness.odd, first_everywhere(thickness.even)), thickness.even};
  const SignHalves thickness_east{thickness.odd, after(thickness.even, last_everywhere(thickness.odd))};
  const SignHalves west{sign(north.even, before(north.odd, first_everywhere(north.even))),
                        sign(north.odd, north.even)};
  const SignHalves east{west.odd, after(west.even, level)};
  const auto last = last_everywhere(north.odd);
  const SignHalves far_east{sign(after(north.even, last), north.even),
                            sign(after(north.odd, last), north.odd)};

  // In the order of kPairs.
  const SignHalves thickness_4 = four(thickness);
  const SignHalves thickness_east_4{thickness_4.odd, times_four(thickness_east.odd)};
  add(step_west, four(step_east));
  add(floor, thickness_east_4);
  add(west, four(east));
  add(step, four(step_far_west));
  add(far_east, four(step_far_east));
  add(thickness_west, thickness_east_4);
  add(west, thickness_4);
  add(east, thickness_4);
  add(floor, thickness_4);
  odd.west = west.odd;
  odd.east = east.odd;
  odd.thickness = thickness.odd;
}

/// Adds what the symbols of the even columns tell of the odd ones.
HWY_INLINE void hear(OddScores& odd, const Weights& weights, HalfVec even_symbols) {
  const HalfVec west = times_four(even_symbols);
  const HalfVec east = after(west, hn::Zero(Half{}));
  static_assert(kPairsOfEven + 4 == kPairs.size());
  odd.scores.add(weights[kPairsOfEven], hn::Or(odd.west, west));
  odd.scores.add(weights[kPairsOfEven + 1], hn::Or(odd.east, east));
  odd.scores.add(weights[kPairsOfEven + 2], hn::Or(odd.thickness, west));
  odd.scores.add(weights[kPairsOfEven + 3], hn::Or(odd.thickness, east));
}

HWY_INLINE RowVec predicted(RowVec north, RowVec floor, RowVec floor_north) {
  return hn::IfThenElse(hn::Eq(north, floor_north), floor, hn::Max(north, floor));
}

/// Bit x set where column x has the symbol kOther.
HWY_INLINE std::uint32_t columns_of_other(HalfVec even, HalfVec odd) {
  const Half d;
  const auto other = hn::Set(d, std::uint8_t{kOther});
  std::uint8_t bits[8] = {};  // StoreMaskBits may write eight
  hn::StoreMaskBits(d, hn::Eq(hn::InterleaveLower(d, even, odd), other), bits);
  std::uint32_t all = bits[0] | std::uint32_t{bits[1]} << 8U;
  hn::StoreMaskBits(d, hn::Eq(hn::InterleaveUpper(d, even, odd), other), bits);
  all |= std::uint32_t{bits[0]} << 16U | std::uint32_t{bits[1]} << 24U;
  return all;
}

/// As before the first row of a plane.
HWY_INLINE Known known_of(const std::uint8_t* below) {
  Known known;
  known.floor_north = load_row(below);
  known.north = known.floor_north;
  known.steps_north = {hn::Zero(HalfRows{}), hn::Zero(HalfRows{})};
  return known;
}

// ---- Reading ----

/// The states with a byte more where they are below kLeastState, lane after lane.
HWY_INLINE void refill(WordParts& states, const std::uint8_t*& next) {
  const Words words;
#if HWY_TARGET == HWY_AVX3
  // One instruction deals the bytes out to the lanes.
  auto& state = states.part[0];
  const auto takes = hn::Lt(state, hn::Set(words, kLeastState));
  const __m512i bytes = _mm512_cvtepu8_epi32(hn::LoadU(Half{}, next).raw);
  const WordVec more{_mm512_cvtepi32_epi16(_mm512_maskz_expand_epi32(takes.raw, bytes))};
  state = hn::Or(hn::IfThenElse(takes, hn::ShiftLeft<8>(state), state), more);
  next += std::popcount(static_cast<std::uint16_t>(takes.raw));
#else
  const SignedWords compared;
  const Half d;
  WordParts takes;
  for (std::size_t p = 0; p < kParts; ++p) {
    // Of the state itself a comparison with a sign would be wrong.
    const auto high = hn::BitCast(compared, hn::ShiftRight<8>(states.part[p]));
    takes.part[p] = hn::BitCast(words, hn::VecFromMask(compared, hn::Eq(high, hn::Zero(compared))));
  }
  const HalfVec taking = narrow_small(takes);  // -1 in the lanes that take a byte
  // How many do so up to each lane, less than 0.
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

/// The symbols of half a row.
HWY_INLINE HalfVec take_symbols(WordParts& states, const OddsParts& odds, const std::uint8_t*& next) {
  const Words d;
  const SignedWords signed_words;
  WordParts symbols;
  for (std::size_t p = 0; p < kParts; ++p) {
    const auto state = states.part[p];
    const auto place = hn::And(state, hn::Set(d, kOddsTotal - 1));
    // All ones where the place lies before where a symbol's share starts. None of them is above kOddsTotal.
    const auto is_before = [&](WordVec start) HWY_ATTR {
      const auto a = hn::BitCast(signed_words, place);
      return hn::BitCast(d, hn::VecFromMask(signed_words, hn::Lt(a, hn::BitCast(signed_words, start))));
    };
    const auto up = odds.up.part[p];
    const auto down = odds.down.part[p];
    const auto other = odds.other.part[p];
    const auto before_up = is_before(up);
    const auto before_down = is_before(down);
    const auto before_other = is_before(other);
    // The last that is not after the place, and the first that is.
    const auto start = hn::Max(hn::AndNot(before_up, up),
                               hn::Max(hn::AndNot(before_down, down), hn::AndNot(before_other, other)));
    const auto end = hn::Min(hn::Min(hn::Or(hn::Not(before_up), up), hn::Or(hn::Not(before_down), down)),
                             hn::Min(hn::Or(hn::Not(before_other), other), hn::Set(d, kOddsTotal)));
    states.part[p] = hn::Add(hn::Mul(hn::Sub(end, start), hn::ShiftRight<8>(state)), hn::Sub(place, start));
    symbols.part[p] =
        hn::Add(hn::Add(hn::Set(d, std::uint16_t{kOther}), before_up), hn::Add(before_down, before_other));
  }
  const HalfVec taken = narrow_small(symbols);
  refill(states, next);
  return taken;
}

/// 0, 1, -1; 0 for kOther, too.
HWY_INLINE RowVec steps_of(HalfVec symbols) {
  alignas(16) static constexpr std::int8_t kStep[16] = {0, 1, -1};
  const HalfRows d;
  return hn::TableLookupBytes(hn::Load(d, kStep), hn::BitCast(d, symbols));
}

HWY_INLINE hn::Mask<HalfRows> outside(RowVec row, RowVec floor) {
  const HalfRows d;
  return hn::Or(hn::Lt(row, floor), hn::Gt(row, hn::Set(d, kChunkSize)));
}

/// Each column's step from how each differs from the one to its west. A step that a byte does not hold
/// becomes the byte's end, which lies out of every plane's range: that row is a fault, whatever its other
/// columns are.
HWY_INLINE RowHalves summed(RowHalves changes) {
  const hn::Half<Half> bytes;
  const hn::RebindToSigned<decltype(bytes)> half;
  const hn::Repartition<std::int16_t, HalfRows> words;
  const auto sums_of_8 = [&](auto v) HWY_ATTR {
    v = hn::Add(v, hn::ShiftLeftLanes<1>(words, v));
    v = hn::Add(v, hn::ShiftLeftLanes<2>(words, v));
    return hn::Add(v, hn::ShiftLeftLanes<4>(words, v));
  };
  const auto even_low = hn::PromoteTo(words, hn::LowerHalf(half, changes.even));
  const auto even_high = hn::PromoteTo(words, hn::UpperHalf(half, changes.even));
  const auto odd_low = hn::PromoteTo(words, hn::LowerHalf(half, changes.odd));
  const auto odd_high = hn::PromoteTo(words, hn::UpperHalf(half, changes.odd));
  const auto low = sums_of_8(hn::Add(even_low, odd_low));
  const auto high = hn::Add(sums_of_8(hn::Add(even_high, odd_high)), hn::Broadcast<7>(low));
  const auto as_bytes = [&](auto a, auto b) HWY_ATTR {
    return hn::Combine(HalfRows{}, hn::DemoteTo(half, b), hn::DemoteTo(half, a));
  };
  return {as_bytes(hn::Sub(low, odd_low), hn::Sub(high, odd_high)), as_bytes(low, high)};
}

PlaneFault read(PlaneSource& source, const std::uint8_t* below, std::uint8_t* plane) {
  bool fault = false;
  const std::uint32_t carried = take_carried(source, fault);
  if (source.next > source.end) return PlaneFault::truncated;
  if (fault) return PlaneFault::bad_number;
  const Half d;
  const HalfRows rows;
  const Words words;
  WordParts states;
  for (std::size_t p = 0; p < kParts; ++p) {
    states.part[p] = hn::LoadU(words, source.states.data() + p * hn::MaxLanes(words));
  }
  const std::uint8_t* next = source.next;
  const auto other = hn::Set(d, std::uint8_t{kOther});
  Known known = known_of(below);
  for (std::size_t z = 0; z < kChunkSize; ++z) {
    known.floor = load_row(below + z * kChunkSize);
    const RowKind kind = kind_of(carried, z);
    Scores of_even;
    OddScores of_odd;
    score(known, kWeights[kind], of_even, of_odd);
    const HalfVec even = take_symbols(states, of_even.odds(), next);
    hear(of_odd, kWeights[kind][1], even);
    const HalfVec odd = take_symbols(states, of_odd.scores.odds(), next);
    RowHalves steps{steps_of(even), steps_of(odd)};
    if (HWY_UNLIKELY(!hn::AllFalse(d, hn::Or(hn::Eq(even, other), hn::Eq(odd, other))))) {
      Steps mended;
      store_row(steps, reinterpret_cast<std::uint8_t*>(mended.data()));
      next = take_others(next, columns_of_other(even, odd), mended);
      steps = load_row(reinterpret_cast<const std::uint8_t*>(mended.data()));
    }
    if (HWY_UNLIKELY(kind != kLevel)) steps = summed(steps);
    if (HWY_UNLIKELY(next > source.end)) return PlaneFault::truncated;
    // What is too large for a byte stays outside.
    const RowHalves row{
        hn::SaturatedAdd(predicted(known.north.even, known.floor.even, known.floor_north.even), steps.even),
        hn::SaturatedAdd(predicted(known.north.odd, known.floor.odd, known.floor_north.odd), steps.odd)};
    if (HWY_UNLIKELY(!hn::AllFalse(
            rows, hn::Or(outside(row.even, known.floor.even), outside(row.odd, known.floor.odd))))) {
      return PlaneFault::bad_number;
    }
    store_row(row, plane + z * kChunkSize);
    known.north = row;
    known.steps_north = steps;
    known.floor_north = known.floor;
  }
  source.next = next;
  for (std::size_t p = 0; p < kParts; ++p) {
    hn::StoreU(states.part[p], words, source.states.data() + p * hn::MaxLanes(words));
  }
  return PlaneFault::none;
}

// ---- Writing ----

HWY_INLINE HalfVec symbols_of(RowVec changes) {
  const HalfRows d;
  const auto same = hn::Eq(changes, hn::Zero(d));
  const auto up = hn::Eq(changes, hn::Set(d, 1));
  const auto down = hn::Eq(changes, hn::Set(d, -1));
  const auto not_up = hn::IfThenElse(down, hn::Set(d, kDown), hn::Set(d, kOther));
  return hn::BitCast(Half{}, hn::IfThenZeroElse(same, hn::IfThenElse(up, hn::Set(d, kUp), not_up)));
}

/// Where the symbols' shares start, and how large they are.
HWY_INLINE void put_shares(HalfVec symbols, const OddsParts& odds, std::uint16_t* starts,
                           std::uint16_t* sizes) {
  const Words d;
  const WordParts symbol = widen(symbols);
  for (std::size_t p = 0; p < kParts; ++p) {
    const auto up = odds.up.part[p];
    const auto down = odds.down.part[p];
    const auto other = odds.other.part[p];
    const auto is = [&](Symbol each)
                        HWY_ATTR { return hn::Eq(symbol.part[p], hn::Set(d, std::uint16_t{each})); };
    const auto is_same = is(kSame);
    const auto is_up = is(kUp);
    const auto is_down = is(kDown);
    const auto start =
        hn::IfThenZeroElse(is_same, hn::IfThenElse(is_up, up, hn::IfThenElse(is_down, down, other)));
    const auto end = hn::IfThenElse(
        is_same, up, hn::IfThenElse(is_up, down, hn::IfThenElse(is_down, other, hn::Set(d, kOddsTotal))));
    hn::StoreU(start, d, starts + p * hn::MaxLanes(d));
    hn::StoreU(hn::Sub(end, start), d, sizes + p * hn::MaxLanes(d));
  }
}

void weigh(const std::uint8_t* plane, const std::uint8_t* below, PlaneShares& shares) {
  const HalfRows rows;
  Known known = known_of(below);
  shares.carried = 0;
  for (std::size_t z = 0; z < kChunkSize; ++z) {
    known.floor = load_row(below + z * kChunkSize);
    const RowHalves row = load_row(plane + z * kChunkSize);
    const RowHalves steps{
        hn::Sub(row.even, predicted(known.north.even, known.floor.even, known.floor_north.even)),
        hn::Sub(row.odd, predicted(known.north.odd, known.floor.odd, known.floor_north.odd))};
    RowHalves changes = steps;
    HalfVec even = symbols_of(steps.even);
    HalfVec odd = symbols_of(steps.odd);
    RowKind kind = z == 0 ? kFirst : kLevel;
    if (kind == kLevel && columns_of_other(even, odd) != 0) {
      Steps all;
      store_row(steps, reinterpret_cast<std::uint8_t*>(all.data()));
      kind = better_kind(all);
      if (kind == kCarried) shares.carried |= 1U << z;
    }
    if (kind != kLevel) {
      changes = {hn::Sub(steps.even, before(steps.odd, hn::Zero(rows))), hn::Sub(steps.odd, steps.even)};
      even = symbols_of(changes.even);
      odd = symbols_of(changes.odd);
    }
    Scores of_even;
    OddScores of_odd;
    score(known, kWeights[kind], of_even, of_odd);
    std::uint16_t* const starts = shares.start.data() + z * kChunkSize;
    std::uint16_t* const sizes = shares.size.data() + z * kChunkSize;
    put_shares(even, of_even.odds(), starts, sizes);
    hear(of_odd, kWeights[kind][1], even);
    put_shares(odd, of_odd.scores.odds(), starts + kLanes, sizes + kLanes);
    shares.others[z] = columns_of_other(even, odd);
    if (shares.others[z] != 0) {
      store_row(changes, reinterpret_cast<std::uint8_t*>(shares.changes.data() + z * kChunkSize));
    }
    known.north = row;
    known.steps_north = steps;
    known.floor_north = known.floor;
  }
}

/// a / b, of words, b not 0. Floats of 24 bits have room for a quotient below 2^16 and more than as many
/// digits behind it as tell it from the next: rounded down it is exact.
HWY_INLINE WordVec divided(WordVec a, WordVec b) {
  const hn::Half<Words> half;
  const hn::Repartition<float, Words> floats;
  const hn::Repartition<std::int32_t, Words> integers;
  const auto part = [&](auto x, auto y) HWY_ATTR {
    const auto dividend = hn::ConvertTo(floats, hn::PromoteTo(integers, x));
    const auto divisor = hn::ConvertTo(floats, hn::PromoteTo(integers, y));
    return hn::DemoteTo(half, hn::ConvertTo(integers, hn::Div(dividend, divisor)));
  };
  return hn::Combine(Words{}, part(hn::UpperHalf(half, a), hn::UpperHalf(half, b)),
                     part(hn::LowerHalf(half, a), hn::LowerHalf(half, b)));
}

/// The symbols of half a row.
HWY_INLINE void put_symbols(WordParts& states, const std::uint16_t* starts, const std::uint16_t* sizes,
                            std::uint8_t*& next) {
  const Words d;
  const SignedWords compared;
  WordParts full;
  WordParts low;
  for (std::size_t p = 0; p < kParts; ++p) {
    const auto state = states.part[p];
    const auto size = hn::LoadU(d, sizes + p * hn::MaxLanes(d));
    const auto start = hn::LoadU(d, starts + p * hn::MaxLanes(d));
    // Would it grow past 16 bits? Of high bytes and sizes none is above 255.
    const auto high = hn::ShiftRight<8>(state);
    const auto fits = hn::BitCast(
        d, hn::VecFromMask(compared, hn::Lt(hn::BitCast(compared, high), hn::BitCast(compared, size))));
    full.part[p] = hn::Not(fits);
    low.part[p] = hn::And(state, hn::Set(d, kOddsTotal - 1));
    const auto left = hn::IfThenElse(hn::MaskFromVec(fits), state, high);
    const auto quotient = divided(left, size);
    const auto rest = hn::Sub(left, hn::Mul(quotient, size));
    states.part[p] = hn::Add(hn::ShiftLeft<8>(quotient), hn::Add(rest, start));
  }
  const Half half;
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(half, hn::MaskFromVec(narrow(full)), bits);
  std::uint32_t lanes = bits[0] | std::uint32_t{bits[1]} << 8U;
  if (lanes == 0) return;
  alignas(16) std::array<std::uint8_t, kLanes> bytes;
  hn::Store(narrow(low), half, bytes.data());
  while (lanes != 0) {
    const auto lane = static_cast<std::uint32_t>(std::bit_width(lanes) - 1);
    *--next = bytes[lane];
    lanes ^= 1U << lane;
  }
}

void write(const PlaneShares& shares, PlaneSink& sink) {
  const Words words;
  WordParts states;
  for (std::size_t p = 0; p < kParts; ++p) {
    states.part[p] = hn::LoadU(words, sink.states.data() + p * hn::MaxLanes(words));
  }
  for (std::size_t z = kChunkSize; z-- > 0;) {
    put_others(sink, shares, z);
    std::uint8_t* next = sink.next;
    for (const std::size_t at : {z * kChunkSize + kLanes, z * kChunkSize}) {
      put_symbols(states, shares.start.data() + at, shares.size.data() + at, next);
    }
    sink.next = next;
  }
  put_carried(sink, shares.carried);
  for (std::size_t p = 0; p < kParts; ++p) {
    hn::StoreU(states.part[p], words, sink.states.data() + p * hn::MaxLanes(words));
  }
}

#endif

}  // namespace

constexpr PlaneKernels kPlanes{read, weigh, write};

}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::codec {

const PlaneKernels& plane_kernels(InstructionSet set) {
  static constexpr const PlaneKernels* kTables[] = TALUS_TABLES(kPlanes);
  return *kTables[static_cast<std::size_t>(set)];
}

const PlaneKernels& plane_kernels() {
  static const PlaneKernels& kKernels = plane_kernels(instruction_set());
  return kKernels;
}

}  // namespace talus::codec
#endif
