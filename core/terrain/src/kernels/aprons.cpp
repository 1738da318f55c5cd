#include "aprons.h"

#include <talus/vectors/tables.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/aprons.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <talus/vectors/vectors-inl.h>

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using talus::HWY_NAMESPACE::over_row;

using Columns = hn::ScalableTag<std::int32_t>;

// Widens a range by the vector at x if any lane of the mask is set.
template <class Tag, class Mask>
HWY_INLINE void include_vector(Tag d, Mask mask, std::size_t x, ColumnRange& range) {
  if (hn::AllFalse(d, mask)) return;
  if (range.last == 0) range.first = x;
  range.last = x + hn::Lanes(d);
}

ColumnRange start_feet(const std::int32_t* height, const std::int32_t* slope, std::size_t width,
                       std::int32_t wall_fx, std::int32_t* foot, std::int32_t* next) {
  ColumnRange walls;
  over_row(Columns{}, width, [=, &walls](auto d, std::size_t x) HWY_ATTR {
    const auto wall = hn::Gt(hn::LoadU(d, slope + x), hn::Set(d, wall_fx));
    include_vector(d, wall, x, walls);
    const auto low = hn::IfThenElse(wall, hn::Set(d, kNoGround_fx), hn::LoadU(d, height + x));
    hn::StoreU(low, d, foot + x);
    hn::StoreU(low, d, next + x);
  });
  return walls;
}

void descend(const std::int32_t* feet, std::size_t stride, const std::int32_t* slope, std::size_t width,
             std::int32_t wall_fx, bool diagonals, std::int32_t* foot) {
  over_row(Columns{}, width, [=](auto d, std::size_t x) HWY_ATTR {
    const std::int32_t* own = feet + stride + x;
    const auto before = hn::LoadU(d, own + 1);
    const auto wall = hn::Gt(hn::LoadU(d, slope + x), hn::Set(d, wall_fx));
    if (hn::AllFalse(d, wall)) {
      hn::StoreU(before, d, foot + x);
      return;
    }
    auto lowest = hn::Min(before, hn::Min(hn::LoadU(d, own), hn::LoadU(d, own + 2)));
    for (const std::int32_t* row : {own - stride, own + stride}) {
      lowest = hn::Min(lowest, hn::LoadU(d, row + 1));
      if (diagonals) lowest = hn::Min(lowest, hn::Min(hn::LoadU(d, row), hn::LoadU(d, row + 2)));
    }
    hn::StoreU(hn::IfThenElse(wall, lowest, before), d, foot + x);
  });
}

// A row may be added to itself, shifted: reads are ahead of writes, so no vector may be processed twice.
void add_row(const std::int32_t* other, std::size_t width, std::int32_t* sum) {
  const Columns d;
  std::size_t x = 0;
  for (; x + hn::Lanes(d) <= width; x += hn::Lanes(d)) {
    hn::StoreU(hn::Add(hn::LoadU(d, sum + x), hn::LoadU(d, other + x)), d, sum + x);
  }
  for (; x < width; ++x) sum[x] += other[x];
}

void halve_row(std::size_t width, int times, std::int32_t* sum) {
  const Columns d;
  std::size_t x = 0;
  for (; x + hn::Lanes(d) <= width; x += hn::Lanes(d)) {
    hn::StoreU(hn::ShiftRightSame(hn::LoadU(d, sum + x), times), d, sum + x);
  }
  for (; x < width; ++x) sum[x] >>= times;
}

ColumnRange begin_aprons(const std::int32_t* height, const std::int32_t* slope, const std::int32_t* foot,
                         const std::int32_t* mean, std::size_t width, const ApronSupply& supply,
                         const ApronRows& out) {
  ColumnRange begins;
  over_row(Columns{}, width, [=, &begins](auto d, std::size_t x) HWY_ATTR {
    const auto own = hn::LoadU(d, height + x);
    const auto low = hn::LoadU(d, foot + x);
    const auto none = hn::Set(d, kNoGround_fx);
    const auto wall = hn::Gt(hn::LoadU(d, slope + x), hn::Set(d, supply.wall_fx));
    const auto above = hn::And(wall, hn::Lt(low, own));
    const auto rock = hn::Max(hn::Sub(hn::LoadU(d, mean + x), low), hn::Zero(d));
    const auto share =
        hn::ShiftRight<8>(hn::Mul(hn::Min(rock, hn::Set(d, supply.enough_fx)), hn::Set(d, supply.share_q8)));
    const auto given = hn::Min(share, hn::Set(d, supply.max_fx));
    const auto leaning = hn::Add(low, given);
    const auto surface = hn::IfThenElse(above, hn::Min(own, leaning), own);
    // A wall is bare above its apron, and if its foot is out of reach.
    const auto free = hn::Or(hn::AndNot(hn::Lt(own, leaning), above), hn::And(wall, hn::Eq(low, none)));
    const auto source = hn::And(above, hn::Gt(given, hn::Zero(d)));
    include_vector(d, source, x, begins);
    hn::StoreU(hn::IfThenElse(free, none, own), d, out.floor + x);
    hn::StoreU(hn::IfThenElse(source, surface, hn::Neg(none)), d, out.top + x);
    hn::StoreU(surface, d, out.surface + x);
  });
  return begins;
}

void spread_aprons(const std::int32_t* tops, std::size_t stride, const std::int32_t* floor, std::size_t width,
                   std::int32_t c_fx, std::int32_t diagonal_fx, std::int32_t thickest_fx, std::int32_t* top) {
  over_row(Columns{}, width, [=](auto d, std::size_t x) HWY_ATTR {
    const std::int32_t* own = tops + stride + x;
    const std::int32_t* north = own - stride;
    const std::int32_t* south = own + stride;
    const auto straight = hn::Max(hn::Max(hn::LoadU(d, own), hn::LoadU(d, own + 2)),
                                  hn::Max(hn::LoadU(d, north + 1), hn::LoadU(d, south + 1)));
    auto reached = hn::Sub(straight, hn::Set(d, c_fx));
    if (diagonal_fx != 0) {
      const auto diagonal = hn::Max(hn::Max(hn::LoadU(d, north), hn::LoadU(d, north + 2)),
                                    hn::Max(hn::LoadU(d, south), hn::LoadU(d, south + 2)));
      reached = hn::Max(reached, hn::Sub(diagonal, hn::Set(d, diagonal_fx)));
    }
    const auto ground = hn::LoadU(d, floor + x);
    const auto none = hn::Set(d, kNoGround_fx);
    const auto before = hn::IfThenElse(hn::Eq(ground, none), hn::Neg(none), hn::LoadU(d, own + 1));
    const auto bounded = hn::Min(reached, hn::Add(ground, hn::Set(d, thickest_fx)));
    hn::StoreU(hn::IfThenElse(hn::Gt(reached, ground), hn::Max(before, bounded), before), d, top + x);
  });
}

void cover_row(const std::int32_t* top, std::size_t width, std::int32_t* surface) {
  over_row(Columns{}, width, [=](auto d, std::size_t x) HWY_ATTR {
    hn::StoreU(hn::Max(hn::LoadU(d, surface + x), hn::LoadU(d, top + x)), d, surface + x);
  });
}

void finish_aprons(const std::int32_t* surfaces, std::size_t stride, const std::int32_t* height,
                   const std::int32_t* top, std::size_t width, std::int32_t c_fx, std::int32_t bare_fx,
                   std::int32_t* raised) {
  over_row(Columns{}, width, [=](auto d, std::size_t x) HWY_ATTR {
    const auto own = hn::LoadU(d, height + x);
    const auto apron = hn::LoadU(d, top + x);
    const auto covered = hn::Gt(apron, own);
    if (hn::AllFalse(d, covered)) {
      hn::StoreU(own, d, raised + x);
      return;
    }
    const auto across = [d](const std::int32_t* row) HWY_ATTR {
      const auto ends = hn::Add(hn::LoadU(d, row), hn::LoadU(d, row + 2));
      return hn::Add(ends, hn::ShiftLeft<1>(hn::LoadU(d, row + 1)));
    };
    const std::int32_t* row = surfaces + x;
    const auto sides = hn::Add(across(row), across(row + 2 * stride));
    const auto smooth = hn::ShiftRight<4>(hn::Add(sides, hn::ShiftLeft<1>(across(row + stride))));
    const auto highest = hn::Min(smooth, hn::Add(apron, hn::Set(d, c_fx >> 1)));
    const auto room = hn::Sub(own, hn::Set(d, bare_fx));
    const auto thickness = hn::Max(hn::Min(hn::Sub(highest, own), room), hn::Zero(d));
    hn::StoreU(hn::Add(own, hn::IfThenElseZero(covered, thickness)), d, raised + x);
  });
}

}  // namespace

constexpr ApronKernels kAprons{start_feet,   descend,       add_row,   halve_row,
                               begin_aprons, spread_aprons, cover_row, finish_aprons};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const ApronKernels& apron_kernels(InstructionSet set) {
  static constexpr const ApronKernels* kTables[] = TALUS_TABLES(kAprons);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
