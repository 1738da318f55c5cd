#include "plane_kernels.h"

#include <talus/vectors/tables.h>

#include "plane_scalar.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plane_read.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "plane-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

using namespace codec;

#if HWY_TARGET == HWY_SCALAR

PlaneFault decode(RansSource& source, const std::uint8_t* below, std::uint8_t* plane) {
  return decode_plane_scalar(source, below, plane);
}

#else

/// 0, 1 or -1; 0 for kOther too.
HWY_INLINE RowVec8 steps_of(HalfVec symbols) {
  alignas(16) static constexpr std::int8_t kStep[16] = {0, 1, -1};
  const HalfRows d;
  return hn::TableLookupBytes(hn::Load(d, kStep), hn::BitCast(d, symbols));
}

HWY_INLINE hn::Mask<HalfRows> outside(RowVec8 row, RowVec8 floor) {
  const HalfRows d;
  return hn::Or(hn::Lt(row, floor), hn::Gt(row, hn::Set(d, kChunkSize)));
}

/// Sums differences from the west to steps. A step that does not fit a byte saturates, which is outside every
/// plane's range: the row is then a fault, whatever its other columns are.
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

PlaneFault decode(RansSource& source, const std::uint8_t* below, std::uint8_t* plane) {
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
  RowContext context = first_row_context(below);
  for (std::size_t z = 0; z < kChunkSize; ++z) {
    context.floor = load_row(below + z * kChunkSize);
    const RowKind kind = kind_of(carried, z);
    Scores of_even;
    OddScores of_odd;
    score(context, kWeights[kind], of_even, of_odd);
    const HalfVec even = decode_symbols(states, of_even.starts(), next);
    add_neighbour_context(of_odd, kWeights[kind][1], even);
    const HalfVec odd = decode_symbols(states, of_odd.scores.starts(), next);
    RowHalves steps{steps_of(even), steps_of(odd)};
    if (HWY_UNLIKELY(!hn::AllFalse(d, hn::Or(hn::Eq(even, other), hn::Eq(odd, other))))) {
      Steps patched;
      store_row(steps, reinterpret_cast<std::uint8_t*>(patched.data()));
      next = take_others(next, columns_of_other(even, odd), patched);
      steps = load_row(reinterpret_cast<const std::uint8_t*>(patched.data()));
    }
    if (HWY_UNLIKELY(kind != kLevel)) steps = summed(steps);
    if (HWY_UNLIKELY(next > source.end)) return PlaneFault::truncated;
    // Saturated values stay out of range.
    const RowHalves row{
        hn::SaturatedAdd(predicted(context.north.even, context.floor.even, context.floor_north.even),
                         steps.even),
        hn::SaturatedAdd(predicted(context.north.odd, context.floor.odd, context.floor_north.odd),
                         steps.odd)};
    if (HWY_UNLIKELY(!hn::AllFalse(
            rows, hn::Or(outside(row.even, context.floor.even), outside(row.odd, context.floor.odd))))) {
      return PlaneFault::bad_number;
    }
    store_row(row, plane + z * kChunkSize);
    context.north = row;
    context.steps_north = steps;
    context.floor_north = context.floor;
  }
  source.next = next;
  for (std::size_t p = 0; p < kParts; ++p) {
    hn::StoreU(states.part[p], words, source.states.data() + p * hn::MaxLanes(words));
  }
  return PlaneFault::none;
}

#endif

}  // namespace

constexpr PlaneDecode kDecode = decode;

}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::codec {

PlaneDecode plane_decode(InstructionSet set) {
  static constexpr const PlaneDecode* kTables[] = TALUS_TABLES(kDecode);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::codec
#endif
