#include "plane_scalar.h"

#include "plane_weights.h"

namespace talus::codec {
namespace {

/// The column coded at place `at` of its row: even columns first.
constexpr std::size_t column_at(std::size_t at) {
  return at % kLanes * 2 + at / kLanes;
}

}  // namespace

Starts starts_of(const RowsBefore& before, RowKind kind, const Symbols& symbols, std::size_t x) {
  const Signs signs = signs_of(before, symbols, static_cast<int>(x));
  int same = 0;
  int up = 0;
  for (std::size_t p = 0; p < pairs_of(x); ++p) {
    const std::size_t place = place_of_pair(signs[kPairs[p][0]], signs[kPairs[p][1]]);
    same = add_weight(same, kWeights[kind][x % 2][p].same[place]);
    up = add_weight(up, kWeights[kind][x % 2][p].up[place]);
  }
  const int end = kSameEnd[class_of(same)];
  const int other = kOtherStart[class_of(same)];
  return {0, end, end + 1 + ((other - end - 2) * kUpSplit[class_of(up)] >> 8), other, kProbabilityTotal};
}

namespace {

/// Sums differences from the west to steps. Steps that do not fit a byte saturate, outside every plane's
/// range.
void sum_up(Steps& steps) {
  int step = 0;
  for (std::int8_t& each : steps) {
    step = std::clamp(step + each, -128, 127);
    each = static_cast<std::int8_t>(step);
  }
}

}  // namespace

PlaneFault decode_plane_scalar(RansSource& source, const std::uint8_t* below, std::uint8_t* plane) {
  bool fault = false;
  const std::uint32_t carried = take_carried(source, fault);
  if (source.next > source.end) return PlaneFault::truncated;
  if (fault) return PlaneFault::bad_number;
  Steps north{};
  for (std::size_t z = 0; z < kChunkSize; ++z) {
    const RowsBefore before = RowsBefore::of(plane, below, z, north);
    const RowKind kind = kind_of(carried, z);
    Symbols symbols{};
    std::uint32_t others = 0;
    Steps steps{};
    for (std::size_t at = 0; at < kChunkSize; ++at) {
      const std::size_t x = column_at(at);
      symbols[x] =
          static_cast<Symbol>(decode_symbol(source, at % kLanes, starts_of(before, kind, symbols, x).data()));
      if (symbols[x] == kOther) others |= 1U << x;
      steps[x] = static_cast<std::int8_t>(symbols[x] == kUp ? 1 : symbols[x] == kDown ? -1 : 0);
    }
    source.next = take_others(source.next, others, steps);
    if (kind != kLevel) sum_up(steps);
    if (source.next > source.end) return PlaneFault::truncated;
    for (std::size_t x = 0; x < kChunkSize; ++x) {
      const int top = predicted_row(before, x) + steps[x];
      if (top < before.floor[x] || top > kChunkSize) return PlaneFault::bad_number;
      plane[z * kChunkSize + x] = static_cast<std::uint8_t>(top);
    }
    north = steps;
  }
  return PlaneFault::none;
}

void model_plane_scalar(const std::uint8_t* plane, const std::uint8_t* below, PlaneIntervals& intervals) {
  intervals.carried = 0;
  Steps north{};
  for (std::size_t z = 0; z < kChunkSize; ++z) {
    const RowsBefore before = RowsBefore::of(plane, below, z, north);
    Steps steps;
    for (std::size_t x = 0; x < kChunkSize; ++x) {
      steps[x] = static_cast<std::int8_t>(plane[z * kChunkSize + x] - predicted_row(before, x));
    }
    const RowKind kind = z == 0 ? kFirst : better_kind(steps);
    if (kind == kCarried) intervals.carried |= 1U << z;
    Symbols symbols;
    for (std::size_t x = 0; x < kChunkSize; ++x) {
      const int change = steps[x] - (kind != kLevel && x > 0 ? steps[x - 1] : 0);
      symbols[x] = symbol_of(change);
      intervals.changes[z * kChunkSize + x] = static_cast<std::int8_t>(change);
    }
    intervals.others[z] = 0;
    for (std::size_t at = 0; at < kChunkSize; ++at) {
      const std::size_t x = column_at(at);
      const Starts starts = starts_of(before, kind, symbols, x);
      if (symbols[x] == kOther) intervals.others[z] |= 1U << x;
      intervals.start[z * kChunkSize + at] = static_cast<std::uint16_t>(starts[symbols[x]]);
      intervals.size[z * kChunkSize + at] =
          static_cast<std::uint16_t>(starts[symbols[x] + 1U] - starts[symbols[x]]);
    }
    north = steps;
  }
}

void encode_plane_scalar(const PlaneIntervals& intervals, RansSink& sink) {
  for (std::size_t z = kChunkSize; z-- > 0;) {
    put_others(sink, intervals, z);
    for (std::size_t at = kChunkSize; at-- > 0;) {
      encode_symbol(sink, at % kLanes,
                    {intervals.start[z * kChunkSize + at], intervals.size[z * kChunkSize + at]});
    }
  }
  put_carried(sink, intervals.carried);
}

}  // namespace talus::codec
