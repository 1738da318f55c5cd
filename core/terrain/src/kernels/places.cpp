#include "places.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/places.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <talus/vectors/vectors-inl.h>

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using talus::HWY_NAMESPACE::over_row;

using PlaceTag = hn::ScalableTag<float>;

void climate(const JitterRow& jitter, float reciprocal_lapse, std::size_t width, float* temperature,
             float* moisture) {
  const PlaceTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto noise = hn::Mul(hn::LoadU(f, jitter.noise + i), hn::Set(f, 0.047F));
    const auto small = hn::LoadU(f, jitter.small + i);
    const auto over = hn::Max(hn::Sub(hn::LoadU(f, jitter.height + i), hn::Set(f, 15)), hn::Zero(f));
    const auto colder = hn::Mul(over, hn::Set(f, reciprocal_lapse));
    const auto warm = hn::Add(hn::Sub(hn::LoadU(f, temperature + i), colder), noise);
    hn::StoreU(hn::Add(warm, hn::Mul(small, hn::Set(f, 0.05F))), f, temperature + i);
    const auto wet = hn::Add(hn::LoadU(f, moisture + i), noise);
    hn::StoreU(hn::Sub(wet, hn::Mul(small, hn::Set(f, 0.06F))), f, moisture + i);
  }
}

void jitter(const float* noise, float factor, std::size_t width, float* values) {
  const PlaceTag f;
  for (std::size_t i = 0; i < width; i += hn::Lanes(f)) {
    const auto ragged = hn::Mul(hn::LoadU(f, noise + i), hn::Set(f, factor));
    hn::StoreU(hn::Add(hn::LoadU(f, values + i), ragged), f, values + i);
  }
}

void look(std::span<const Places::Case> cases, std::span<const float* const> quantities, std::size_t width,
          std::uint8_t* looks) {
  over_row(PlaceTag{}, width, [=](auto f, std::size_t i) HWY_ATTR {
    const hn::RebindToSigned<decltype(f)> ints;
    auto found = hn::Zero(ints);
    auto open = hn::Eq(found, found);  // true while no case has held
    for (const Places::Case& one : cases) {
      auto holds = open;
      for (const Places::Condition& condition : one.conditions) {
        const auto value = hn::LoadU(f, quantities[condition.quantity] + i);
        const auto limit = hn::Set(f, condition.limit);
        const auto within = condition.above ? hn::Ge(value, limit) : hn::Lt(value, limit);
        holds = hn::And(holds, hn::RebindMask(ints, within));
      }
      found = hn::IfThenElse(holds, hn::Set(ints, one.look), found);
      open = hn::AndNot(holds, open);
      if (hn::AllFalse(ints, open)) break;
    }
    const hn::Rebind<std::uint8_t, decltype(f)> bytes;
    hn::StoreU(hn::DemoteTo(bytes, found), bytes, looks + i);
  });
}

std::uint64_t present(const std::uint8_t* looks, std::size_t width) {
  const hn::ScalableTag<std::uint32_t> words;
  const hn::Rebind<std::uint8_t, decltype(words)> bytes;
  const std::size_t lanes = hn::Lanes(words);
  auto low = hn::Zero(words);
  auto high = low;
  std::size_t i = 0;
  for (; i + lanes <= width; i += lanes) {
    const auto look = hn::PromoteTo(words, hn::LoadU(bytes, looks + i));
    const auto bit = hn::Shl(hn::Set(words, 1), hn::And(look, hn::Set(words, 31)));
    const auto past = hn::Gt(look, hn::Set(words, 31));
    low = hn::Or(low, hn::IfThenZeroElse(past, bit));
    high = hn::Or(high, hn::IfThenElseZero(past, bit));
  }
  std::uint32_t lows[hn::MaxLanes(hn::ScalableTag<std::uint32_t>{})];
  std::uint32_t highs[hn::MaxLanes(hn::ScalableTag<std::uint32_t>{})];
  hn::StoreU(low, words, lows);
  hn::StoreU(high, words, highs);
  std::uint64_t all = 0;
  for (std::size_t k = 0; k < lanes; ++k) all |= std::uint64_t{highs[k]} << 32 | lows[k];
  for (; i < width; ++i) all |= std::uint64_t{1} << looks[i];
  return all;
}

template <class Value>
HWY_INLINE ValueRange range_of(const Value* values, std::size_t width) {
  const hn::ScalableTag<Value> d;
  const std::size_t lanes = hn::Lanes(d);
  auto low = hn::Set(d, values[0]);
  auto high = low;
  std::size_t i = 0;
  for (; i + lanes <= width; i += lanes) {
    const auto value = hn::LoadU(d, values + i);
    low = hn::Min(low, value);
    high = hn::Max(high, value);
  }
  Value least = hn::GetLane(hn::MinOfLanes(d, low));
  Value most = hn::GetLane(hn::MaxOfLanes(d, high));
  for (; i < width; ++i) {
    least = std::min(least, values[i]);
    most = std::max(most, values[i]);
  }
  return {static_cast<float>(least), static_cast<float>(most)};
}

ValueRange range(const float* values, std::size_t width) {
  return range_of(values, width);
}
ValueRange range_of_int32(const std::int32_t* values, std::size_t width) {
  return range_of(values, width);
}

void keep(std::uint64_t wanted, const std::uint8_t* looks, const std::int32_t* share, std::size_t width,
          std::int32_t* kept) {
  over_row(hn::ScalableTag<std::int32_t>{}, width, [=](auto d, std::size_t i) HWY_ATTR {
    const hn::RebindToUnsigned<decltype(d)> words;
    const auto look = hn::PromoteTo(words, hn::LoadU(hn::Rebind<std::uint8_t, decltype(words)>{}, looks + i));
    const auto low = hn::Set(words, static_cast<std::uint32_t>(wanted));
    const auto high = hn::Set(words, static_cast<std::uint32_t>(wanted >> 32));
    const auto of_32 = hn::IfThenElse(hn::Gt(look, hn::Set(words, 31)), high, low);
    const auto bit = hn::Shr(of_32, hn::And(look, hn::Set(words, 31)));
    const auto all = hn::Neg(hn::BitCast(d, hn::And(bit, hn::Set(words, 1))));
    hn::StoreU(hn::And(hn::LoadU(d, share + i), all), d, kept + i);
  });
}

// Truncates, which rounds non-negative numbers down.
template <class F, class V>
HWY_INLINE void thin_at(F f, V value, const Places::Ramp& ramp, const std::int32_t* share,
                        std::int32_t* thinned) {
  const hn::RebindToSigned<F> ints;
  const auto t = hn::Mul(hn::Sub(value, hn::Set(f, ramp.none)), hn::Set(f, ramp.reciprocal));
  const auto unit = hn::Min(hn::Max(t, hn::Zero(f)), hn::Set(f, 1));
  const auto part = hn::ConvertTo(ints, hn::Mul(unit, hn::Set(f, static_cast<float>(kWholeShare))));
  const auto product = hn::Mul(hn::LoadU(ints, share), part);
  static_assert(kWholeShare == 1 << 12);
  hn::StoreU(hn::ShiftRight<12>(product), ints, thinned);
}

void thin(const Places::Ramp& ramp, const float* values, const std::int32_t* share, std::size_t width,
          std::int32_t* thinned) {
  over_row(PlaceTag{}, width, [=, &ramp](auto f, std::size_t i) HWY_ATTR {
    thin_at(f, hn::LoadU(f, values + i), ramp, share + i, thinned + i);
  });
}

void thin_by_int32(const Places::Ramp& ramp, const std::int32_t* values, const std::int32_t* share,
                   std::size_t width, std::int32_t* thinned) {
  over_row(PlaceTag{}, width, [=, &ramp](auto f, std::size_t i) HWY_ATTR {
    const hn::RebindToSigned<decltype(f)> ints;
    thin_at(f, hn::ConvertTo(f, hn::LoadU(ints, values + i)), ramp, share + i, thinned + i);
  });
}

}  // namespace

constexpr PlaceKernels kPlaces{climate,        jitter, look, present,      range,
                               range_of_int32, keep,   thin, thin_by_int32};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const PlaceKernels& place_kernels(InstructionSet set) {
  static constexpr const PlaceKernels* kTables[] = TALUS_TABLES(kPlaces);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
