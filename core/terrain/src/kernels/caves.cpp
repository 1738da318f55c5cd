#include "caves.h"

#include <algorithm>

#include <talus/terrain/world.h>

#include <talus/vectors/tables.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/caves.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <talus/vectors/vectors-inl.h>

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using talus::HWY_NAMESPACE::over_row;

using Ints = hn::ScalableTag<std::int32_t>;

constexpr std::int32_t kOne = 1 << 16;               // the unit of a dome's shape
constexpr std::int32_t kWall_noise = kNoiseOne / 6;  // between a chamber's wall and its full height

template <class D>
HWY_INLINE hn::Vec<D> noise_at(D d, const float* values) {
  const hn::RebindToFloat<D> f;
  return hn::ConvertTo(d, hn::Mul(hn::LoadU(f, values), hn::Set(f, static_cast<float>(kNoiseOne))));
}

/// Depth of columns inside tunnels and chambers; there is air if either is more than 0.
template <class D>
struct Depths {
  hn::Vec<D> in_tunnel;
  hn::Vec<D> in_chamber;

  HWY_INLINE Depths(D d, const CavePlan& plan, const CaveNoises& noises, std::size_t i)
      : in_tunnel{hn::Sub(hn::Set(d, plan.half_width_noise), hn::Abs(noise_at(d, noises.tunnels + i)))},
        in_chamber{hn::Sub(noise_at(d, noises.chambers + i), hn::Set(d, plan.threshold_noise))} {}

  [[nodiscard]] HWY_INLINE hn::Mask<D> air(D d) const {
    return hn::Gt(hn::Max(in_tunnel, in_chamber), hn::Zero(d));
  }
};

/// whole * share / kOne, rounded down, for 0 <= whole < 2^23 + 256 and 0 <= share <= kOne. Computed in two
/// parts, as the product has 40 bits.
template <class D>
HWY_INLINE hn::Vec<D> part(D d, hn::Vec<D> whole, hn::Vec<D> share) {
  const hn::RebindToUnsigned<D> words;
  const auto w = hn::BitCast(words, whole);
  const auto s = hn::BitCast(words, share);
  const auto high = hn::Mul(hn::ShiftRight<8>(w), s);
  const auto low = hn::ShiftRight<8>(hn::Mul(hn::And(w, hn::Set(words, 255)), s));
  return hn::BitCast(d, hn::ShiftRight<8>(hn::Add(high, low)));
}

/// A dome's height at `share` of the way in from its wall: steep near the wall, level in the middle.
template <class D>
HWY_INLINE hn::Vec<D> bulge(D d, hn::Vec<D> share) {
  const auto out = hn::Sub(hn::Set(d, kOne), share);
  return hn::Sub(hn::Set(d, kOne), part(d, out, out));
}

/// kOne * depth / whole, rounded down, for 0 < depth <= whole <= 2^13.
template <class D>
HWY_INLINE hn::Vec<D> share_of(D d, hn::Vec<D> depth, std::int32_t whole) {
  const hn::RebindToFloat<D> f;
  const auto product = hn::ShiftLeft<16>(depth);
  const auto quotient =
      hn::ConvertTo(d, hn::Div(hn::ConvertTo(f, product), hn::Set(f, static_cast<float>(whole))));
  // The float quotient may be rounded up to the next integer.
  const auto past = hn::Lt(product, hn::Mul(quotient, hn::Set(d, whole)));
  return hn::Add(quotient, hn::VecFromMask(d, past));
}

/// Extent of air above and below the middle.
template <class D>
struct Reach {
  hn::Vec<D> rise;
  hn::Vec<D> drop;

  /// Widens columns with `depth` > 0. Three quarters of the height lie above the middle. The floor is the
  /// flatter part: a dome of a dome.
  HWY_INLINE void widen(D d, hn::Vec<D> depth, std::int32_t whole, std::int32_t height_fx) {
    const auto inside = hn::Gt(depth, hn::Zero(d));
    if (hn::AllFalse(d, inside)) return;
    const auto far = hn::Min(hn::Max(depth, hn::Zero(d)), hn::Set(d, whole));
    const auto dome = bulge(d, share_of(d, far, whole));
    const auto height = part(d, hn::Set(d, height_fx), dome);
    const auto up = hn::Sub(height, hn::ShiftRight<2>(height));
    const auto down = hn::ShiftRight<2>(part(d, hn::Set(d, height_fx), bulge(d, dome)));
    rise = hn::Max(rise, hn::IfThenElseZero(inside, up));
    drop = hn::Max(drop, hn::IfThenElseZero(inside, down));
  }
};

ColumnRange find(const CavePlan& plan, const CaveNoises& noises, ColumnRange within) {
  ColumnRange air;
  over_row(Ints{}, within.last - within.first, [=, &plan, &air](auto d, std::size_t i) HWY_ATTR {
    const std::size_t x = within.first + i;
    if (hn::AllFalse(d, Depths{d, plan, noises, x}.air(d))) return;
    if (air.last == 0) air.first = x;
    air.last = x + hn::Lanes(d);
  });
  return air;
}

void shape(const CavePlan& plan, const CaveNoises& noises, ColumnRange columns, int level,
           std::int32_t* floor_fx, std::int32_t* roof_fx) {
  over_row(Ints{}, columns.last - columns.first, [=, &plan](auto d, std::size_t i) HWY_ATTR {
    const std::size_t x = columns.first + i;
    const Depths depths{d, plan, noises, x};
    const auto air = depths.air(d);
    auto floor = hn::Zero(d);
    auto roof = floor;
    if (!hn::AllFalse(d, air)) {
      const auto one = hn::Set(d, kOne);
      const auto climb = hn::ShiftLeft<2>(noise_at(d, noises.climb + x));
      const auto up = hn::Min(hn::Max(hn::Add(climb, hn::Set(d, kOne / 2)), floor), one);
      const auto middle = hn::Add(hn::Set(d, plan.low_fx), part(d, hn::Set(d, plan.climb_fx), up));
      Reach<decltype(d)> reach{floor, floor};
      reach.widen(d, depths.in_tunnel, plan.half_width_noise, plan.height_fx);
      reach.widen(d, depths.in_chamber, kWall_noise, plan.chamber_height_fx);
      const auto least = hn::Set(d, kSubvoxels);
      const auto bottom = hn::Max(hn::Sub(middle, reach.drop), least);
      const auto top = hn::Max(bottom, hn::Add(middle, reach.rise));
      floor = hn::IfThenElseZero(air, hn::Max(hn::ShiftRightSame(bottom, level), least));
      roof = hn::IfThenElseZero(air, hn::ShiftRightSame(top, level));
    }
    hn::StoreU(floor, d, floor_fx + x);
    hn::StoreU(roof, d, roof_fx + x);
  });
}

std::int32_t lowest(const std::int32_t* heights_fx, std::size_t width) {
  std::int32_t least = heights_fx[0];
  over_row(Ints{}, width, [=, &least](auto d, std::size_t i) HWY_ATTR {
    least = std::min(least, hn::GetLane(hn::MinOfLanes(d, hn::LoadU(d, heights_fx + i))));
  });
  return least;
}

/// Sets the bits of columns from `i` on that are set in the mask.
template <class D>
HWY_INLINE void set_bits(D d, hn::Mask<D> mask, std::size_t i, std::uint64_t* bits) {
  constexpr std::size_t kBytes = (hn::MaxLanes(D{}) + 7) / 8;
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  std::uint64_t set = bytes[0];
  if constexpr (kBytes == 2) set |= std::uint64_t{bytes[1]} << 8;
  static_assert(kBytes <= 2);
  bits[i / 64] |= set << (i % 64);
  if (i % 64 + hn::Lanes(d) > 64) bits[i / 64 + 1] |= set >> (64 - i % 64);
}

template <class D>
HWY_INLINE hn::Vec<D> boundary_rows(D d, hn::Vec<D> boundary_fx) {
  return hn::ShiftRight<8>(hn::Add(boundary_fx, hn::Set(d, 127)));
}

void judge(const RoofRules& rules, const HeightsAround& heights, std::size_t width, const JudgedRows& rows) {
  over_row(Ints{}, width, [=, &rules, &rows](auto d, std::size_t x) HWY_ATTR {
    const auto at_level = [&](auto fx) HWY_ATTR { return hn::ShiftRightSame(fx, rules.level); };
    const auto loose = hn::Set(d, rules.loose_fx);
    const auto too_few = hn::Set(d, rules.min_rows - 1);
    const auto far_below = hn::Set(d, kFarBelow);
    const auto surface = at_level(hn::LoadU(d, heights.own + x));
    auto rock_row = boundary_rows(d, hn::Sub(surface, loose));
    auto roof_row = far_below;
    const auto roof = hn::LoadU(d, rows.roof_fx + x);
    if (!hn::AllTrue(d, hn::Eq(roof, hn::Zero(d)))) {
      // Without air both rows are the lowest.
      const auto floor_row = boundary_rows(d, hn::LoadU(d, rows.floor_fx + x));
      const auto own_roof_row = boundary_rows(d, roof);
      const auto thick = hn::Gt(hn::Sub(rock_row, floor_row), too_few);
      const auto hollow = hn::And(thick, hn::Lt(floor_row, own_roof_row));
      auto dry = hn::Eq(roof, roof);
      if (rules.shore) {
        auto lowest_0 = hn::LoadU(d, heights.own + x);
        for (const std::int32_t* row : {heights.north + x, heights.own + x, heights.south + x}) {
          lowest_0 = hn::Min(lowest_0, hn::Min(hn::LoadU(d, row - 1), hn::LoadU(d, row + 1)));
          lowest_0 = hn::Min(lowest_0, hn::LoadU(d, row));
        }
        const auto low = at_level(lowest_0);
        dry = hn::Gt(hn::Sub(low, hn::Set(d, rules.sunk_fx)), hn::Set(d, rules.sea_fx));
        const auto lower = hn::Min(rock_row, boundary_rows(d, hn::Sub(low, loose)));
        rock_row = hn::IfThenElse(hn::AndNot(dry, hollow), lower, rock_row);
      }
      const auto roofed = hn::And(hollow, hn::Gt(hn::Sub(rock_row, own_roof_row), too_few));
      const auto open = hn::And(hn::AndNot(roofed, hollow), dry);
      set_bits(d, roofed, x, rows.roofed);
      set_bits(d, open, x, rows.open);
      roof_row = hn::IfThenElse(roofed, own_roof_row, far_below);
      rock_row = hn::IfThenElse(open, far_below, rock_row);
      // Keeps open columns open if the last vector processes them twice.
      hn::StoreU(hn::IfThenElse(open, surface, roof), d, rows.roof_fx + x);
    }
    hn::StoreU(roof_row, d, rows.roof_row + x);
    hn::StoreU(rock_row, d, rows.rock_row + x);
  });
}

void touch(const std::int32_t* roof_a, const std::int32_t* rock_a, const std::int32_t* roof_b,
           const std::int32_t* rock_b, std::size_t width, std::uint64_t* touching) {
  over_row(Ints{}, width, [=](auto d, std::size_t x) HWY_ATTR {
    const auto roof = hn::Max(hn::LoadU(d, roof_a + x), hn::LoadU(d, roof_b + x));
    const auto rock = hn::Min(hn::LoadU(d, rock_a + x), hn::LoadU(d, rock_b + x));
    set_bits(d, hn::Lt(roof, rock), x, touching);
  });
}

}  // namespace

constexpr CaveKernels kCaves{find, shape, lowest, judge, touch};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const CaveKernels& cave_kernels(InstructionSet set) {
  static constexpr const CaveKernels* kTables[] = TALUS_TABLES(kCaves);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
