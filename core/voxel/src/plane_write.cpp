#include "plane_kernels.h"

#include <talus/vectors/tables.h>

#include "plane_scalar.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plane_write.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "plane-inl.h"

HWY_BEFORE_NAMESPACE();
namespace talus::HWY_NAMESPACE {
namespace {

using namespace codec;

#if HWY_TARGET == HWY_SCALAR

void model(const std::uint8_t* plane, const std::uint8_t* below, PlaneIntervals& intervals) {
  model_plane_scalar(plane, below, intervals);
}

void encode(const PlaneIntervals& intervals, RansSink& sink) {
  encode_plane_scalar(intervals, sink);
}

#else

HWY_INLINE HalfVec symbols_of(RowVec8 changes) {
  const HalfRows d;
  const auto same = hn::Eq(changes, hn::Zero(d));
  const auto up = hn::Eq(changes, hn::Set(d, 1));
  const auto down = hn::Eq(changes, hn::Set(d, -1));
  const auto not_up = hn::IfThenElse(down, hn::Set(d, kDown), hn::Set(d, kOther));
  return hn::BitCast(Half{}, hn::IfThenZeroElse(same, hn::IfThenElse(up, hn::Set(d, kUp), not_up)));
}

/// Stores starts and sizes of the symbols' intervals.
HWY_INLINE void put_intervals(HalfVec symbols, const StartParts& starts, std::uint16_t* start_out,
                              std::uint16_t* size_out) {
  const Words d;
  const WordParts symbol = widen(symbols);
  for (std::size_t p = 0; p < kParts; ++p) {
    const auto up = starts.one.part[p];
    const auto down = starts.two.part[p];
    const auto other = starts.three.part[p];
    const auto is = [&](Symbol each)
                        HWY_ATTR { return hn::Eq(symbol.part[p], hn::Set(d, std::uint16_t{each})); };
    const auto is_same = is(kSame);
    const auto is_up = is(kUp);
    const auto is_down = is(kDown);
    const auto start =
        hn::IfThenZeroElse(is_same, hn::IfThenElse(is_up, up, hn::IfThenElse(is_down, down, other)));
    const auto end = hn::IfThenElse(
        is_same, up,
        hn::IfThenElse(is_up, down, hn::IfThenElse(is_down, other, hn::Set(d, kProbabilityTotal))));
    hn::StoreU(start, d, start_out + p * hn::MaxLanes(d));
    hn::StoreU(hn::Sub(end, start), d, size_out + p * hn::MaxLanes(d));
  }
}

void model(const std::uint8_t* plane, const std::uint8_t* below, PlaneIntervals& intervals) {
  const HalfRows rows;
  RowContext context = first_row_context(below);
  intervals.carried = 0;
  for (std::size_t z = 0; z < kChunkSize; ++z) {
    context.floor = load_row(below + z * kChunkSize);
    const RowHalves row = load_row(plane + z * kChunkSize);
    const RowHalves steps{
        hn::Sub(row.even, predicted(context.north.even, context.floor.even, context.floor_north.even)),
        hn::Sub(row.odd, predicted(context.north.odd, context.floor.odd, context.floor_north.odd))};
    RowHalves changes = steps;
    HalfVec even = symbols_of(steps.even);
    HalfVec odd = symbols_of(steps.odd);
    RowKind kind = z == 0 ? kFirst : kLevel;
    if (kind == kLevel && columns_of_other(even, odd) != 0) {
      Steps all;
      store_row(steps, reinterpret_cast<std::uint8_t*>(all.data()));
      kind = better_kind(all);
      if (kind == kCarried) intervals.carried |= 1U << z;
    }
    if (kind != kLevel) {
      changes = {hn::Sub(steps.even, before(steps.odd, hn::Zero(rows))), hn::Sub(steps.odd, steps.even)};
      even = symbols_of(changes.even);
      odd = symbols_of(changes.odd);
    }
    Scores of_even;
    OddScores of_odd;
    score(context, kWeights[kind], of_even, of_odd);
    std::uint16_t* const starts = intervals.start.data() + z * kChunkSize;
    std::uint16_t* const sizes = intervals.size.data() + z * kChunkSize;
    put_intervals(even, of_even.starts(), starts, sizes);
    add_neighbour_context(of_odd, kWeights[kind][1], even);
    put_intervals(odd, of_odd.scores.starts(), starts + kLanes, sizes + kLanes);
    intervals.others[z] = columns_of_other(even, odd);
    if (intervals.others[z] != 0) {
      store_row(changes, reinterpret_cast<std::uint8_t*>(intervals.changes.data() + z * kChunkSize));
    }
    context.north = row;
    context.steps_north = steps;
    context.floor_north = context.floor;
  }
}

void encode(const PlaneIntervals& intervals, RansSink& sink) {
  const Words words;
  WordParts states;
  for (std::size_t p = 0; p < kParts; ++p) {
    states.part[p] = hn::LoadU(words, sink.states.data() + p * hn::MaxLanes(words));
  }
  for (std::size_t z = kChunkSize; z-- > 0;) {
    put_others(sink, intervals, z);
    std::uint8_t* next = sink.next;
    for (const std::size_t at : {z * kChunkSize + kLanes, z * kChunkSize}) {
      encode_symbols(states, load_words(intervals.start.data() + at), load_words(intervals.size.data() + at),
                     next);
    }
    sink.next = next;
  }
  put_carried(sink, intervals.carried);
  for (std::size_t p = 0; p < kParts; ++p) {
    hn::StoreU(states.part[p], words, sink.states.data() + p * hn::MaxLanes(words));
  }
}

#endif

}  // namespace

constexpr PlaneEncode kEncode{model, encode};

}  // namespace talus::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::codec {

const PlaneEncode& plane_encode(InstructionSet set) {
  static constexpr const PlaneEncode* kTables[] = TALUS_TABLES(kEncode);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::codec
#endif
