// A row of a plane and its context as vectors, and the resulting probabilities. Included once per instruction
// set, hence this guard:
#if defined(TALUS_PLANE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TALUS_PLANE_INL
#undef TALUS_PLANE_INL
#else
#define TALUS_PLANE_INL
#endif

#include <hwy/highway.h>

#include "plane_kernels.h"
#include "plane_weights.h"
#include "rans-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

// Half a row, its even or its odd columns, is a vector of sixteen bytes. Rows are 0 to 32, so signed bytes
// hold them.
using RowVec8 = hn::Vec<HalfRows>;

// Holds a half row twice if vectors are wide enough: both scores are then looked up at once.
using Rows = hn::RebindToSigned<Bytes>;
using ScoreVec = hn::Vec<Rows>;

/// Columns of a row.
struct RowHalves {
  RowVec8 even;
  RowVec8 odd;
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

/// Returns the value of the previous lane in each lane, and `first` in lane 0.
template <class Vec>
HWY_INLINE Vec before(Vec v, Vec first) {
  const Half d;
  return hn::BitCast(hn::DFromV<Vec>{},
                     hn::CombineShiftRightBytes<kLanes - 1>(d, hn::BitCast(d, v), hn::BitCast(d, first)));
}

/// Returns the value of the next lane in each lane, and `last` in the last lane.
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

/// 0, 1 or 2 if a is below, equal to or above b.
HWY_INLINE HalfVec sign(RowVec8 a, RowVec8 b) {
  const HalfRows d;
  const auto above = hn::VecFromMask(d, hn::Gt(a, b));  // -1 where true
  const auto under = hn::VecFromMask(d, hn::Lt(a, b));
  return hn::BitCast(Half{}, hn::Add(hn::Sub(hn::Set(d, 1), above), under));
}

/// Multiplies bytes below 64 by four.
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

/// Scores of a half row. Weights are added in the order of kPairs.
class Scores {
 public:
  HWY_INLINE void clear() {
    both_ = hn::Zero(Rows{});
#if !TALUS_TWICE
    up_ = hn::Zero(Rows{});
#endif
  }

  /// `place`: index into the pair's tables, by lane.
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

  [[nodiscard]] HWY_INLINE StartParts starts() const {
    const Bytes d;
    const Words words;
    const auto classes = class_of(both_);
    const auto other = hn::TableLookupBytes(hn::LoadDup128(d, kOtherStart.data()), classes);
#if TALUS_TWICE
    const auto both = hn::TableLookupBytes(hn::LoadU(d, kEndAndSplit.data()), classes);
    StartParts starts{widen(lower_half(both)), {}, widen(lower_half(other))};
    const WordParts split{{hn::PromoteTo(words, hn::UpperHalf(Half{}, both))}};
#else
    const auto same_end = hn::TableLookupBytes(hn::LoadU(d, kSameEnd.data()), classes);
    StartParts starts{widen(same_end), {}, widen(lower_half(other))};
    const WordParts split = widen(hn::TableLookupBytes(hn::LoadU(d, kUpSplit.data()), class_of(up_)));
#endif
    for (std::size_t p = 0; p < kParts; ++p) {
      const auto end = starts.one.part[p];
      // One value belongs to kUp in any case, and one to kDown.
      const auto first = hn::Add(end, hn::Set(words, 1));
      const auto between = hn::Sub(hn::Sub(starts.three.part[p], first), hn::Set(words, 1));
      starts.two.part[p] = hn::Add(first, hn::ShiftRight<8>(hn::Mul(between, split.part[p])));
    }
    return starts;
  }

 private:
  static HWY_INLINE ByteVec class_of(ScoreVec score) {
    static_assert(kClasses == 16);
    const Bytes d;
    const hn::Repartition<std::uint16_t, Bytes> words;
    const auto positive = hn::BitCast(words, hn::Max(score, hn::Zero(Rows{})));
    // Bytes are below 128: bits shifted in from the higher byte are masked.
    return hn::And(hn::BitCast(d, hn::ShiftRight<3>(positive)), hn::Set(d, 15));
  }

#if TALUS_TWICE
  static constexpr auto kEndAndSplit = [] {
    std::array<std::uint8_t, 2 * kClasses> both{};
    for (std::size_t c = 0; c < kClasses; ++c) {
      both[c] = kSameEnd[c];
      both[kClasses + c] = kUpSplit[c];
    }
    return both;
  }();
#else
  ScoreVec up_;
#endif
  ScoreVec both_;  // of kSame, and also of kUp if vectors hold the lanes twice
};

/// Context of a row that is known before the row is read.
struct RowContext {
  RowHalves north;
  RowHalves steps_north;
  RowHalves floor;
  RowHalves floor_north;
};

/// Scores of odd columns and the values needed to add their neighbours' contribution.
struct OddScores {
  Scores scores;
  HalfVec west;
  HalfVec east;
  HalfVec thickness;
};

/// Computes the scores of the even columns, and of the odd ones except their neighbours' contribution.
HWY_INLINE void score(const RowContext& context, const std::array<Weights, 2>& weights, Scores& even,
                      OddScores& odd) {
  const Half d;
  const HalfRows rows;
  const auto& north = context.north;
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
  const SignHalves step{sign(context.steps_north.even, zero), sign(context.steps_north.odd, zero)};
  const SignHalves step_west{before(step.odd, level), step.even};
  const SignHalves step_east{step.odd, after(step.even, level)};
  const SignHalves step_far_west{before(step.even, level), before(step.odd, level)};
  const SignHalves step_far_east{after(step.even, level), after(step.odd, level)};
  const SignHalves floor{sign(context.floor.even, context.floor_north.even),
                         sign(context.floor.odd, context.floor_north.odd)};
  const auto two = hn::Set(rows, 2);
  const SignHalves thickness{hn::BitCast(d, hn::Min(hn::Sub(north.even, context.floor_north.even), two)),
                             hn::BitCast(d, hn::Min(hn::Sub(north.odd, context.floor_north.odd), two))};
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

/// Adds the contribution of the even columns' symbols to the odd columns' scores.
HWY_INLINE void add_neighbour_context(OddScores& odd, const Weights& weights, HalfVec even_symbols) {
  const HalfVec west = times_four(even_symbols);
  const HalfVec east = after(west, hn::Zero(Half{}));
  static_assert(kPairsOfEven + 4 == kPairs.size());
  odd.scores.add(weights[kPairsOfEven], hn::Or(odd.west, west));
  odd.scores.add(weights[kPairsOfEven + 1], hn::Or(odd.east, east));
  odd.scores.add(weights[kPairsOfEven + 2], hn::Or(odd.thickness, west));
  odd.scores.add(weights[kPairsOfEven + 3], hn::Or(odd.thickness, east));
}

HWY_INLINE RowVec8 predicted(RowVec8 north, RowVec8 floor, RowVec8 floor_north) {
  return hn::IfThenElse(hn::Eq(north, floor_north), floor, hn::Max(north, floor));
}

/// Bit x is set if column x has the symbol kOther.
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

/// Context of the first row of a plane.
HWY_INLINE RowContext first_row_context(const std::uint8_t* below) {
  RowContext context;
  context.floor_north = load_row(below);
  context.north = context.floor_north;
  context.steps_north = {hn::Zero(HalfRows{}), hn::Zero(HalfRows{})};
  return context;
}

}  // namespace
}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
