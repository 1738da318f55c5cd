#include "settle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <talus/vectors/tables.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/settle.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <talus/vectors/vectors-inl.h>

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using talus::HWY_NAMESPACE::over_row;

enum class Direction { east, west };
enum class Metric { chessboard, octagonal };

template <class Cell, class Vec>
HWY_INLINE Vec plus(Vec a, Vec b) {
  if constexpr (sizeof(Cell) == 2) {
    return hn::SaturatedAdd(a, b);
  } else {
    return hn::Add(a, b);
  }
}

// The running minimum of a row: every cell is at most `repose` above the previous one along one direction.
// Input cells are levelled: reduced by the repose accumulated since the vector's first cell, so that "at most
// repose above" becomes "not above", and only shifts and minima are left.
#if HWY_TARGET == HWY_SCALAR
template <class Cell, Direction kDirection>
class RunningMinimum {
 public:
  using Cells = hn::ScalableTag<Cell>;
  using Vec = hn::Vec<Cells>;

  explicit RunningMinimum(std::int32_t repose) : step_{hn::Set(Cells{}, static_cast<Cell>(repose))} {}
  [[nodiscard]] Vec ramp() const { return hn::Zero(Cells{}); }
  void begin_row() { carried_ = hn::Set(Cells{}, kUnbounded<Cell>); }
  Vec next(Vec levelled) {
    const Vec lowered = hn::Min(levelled, carried_);
    carried_ = plus<Cell>(lowered, step_);
    return lowered;
  }

 private:
  Vec step_;
  Vec carried_;
};
#else
/// Vector version: doubling steps within blocks of 16 bytes and between blocks, and a carry between vectors.
template <class Cell, Direction kDirection>
class RunningMinimum {
 public:
  using Cells = hn::ScalableTag<Cell>;
  using Vec = hn::Vec<Cells>;

  HWY_INLINE explicit RunningMinimum(std::int32_t repose)
      : ramp_{ramp_of(repose)},
        whole_vector_{hn::Set(Cells{}, static_cast<Cell>(repose * kLanes))},
        unbounded_{hn::Set(Cells{}, kUnbounded<Cell>)},
        carried_{unbounded_} {}

  /// The amounts by which the lanes of a vector are levelled.
  [[nodiscard]] HWY_INLINE Vec ramp() const { return ramp_; }

  HWY_INLINE void begin_row() { carried_ = unbounded_; }

  /// Takes the next vector of the row in the order of the direction, levelled; returns it not levelled.
  HWY_INLINE Vec next(Vec v) {
    v = hn::Min(v, shifted<1>(v));
    v = hn::Min(v, shifted<2>(v));
    if constexpr (kBlockLanes == 8) v = hn::Min(v, shifted<4>(v));
    if constexpr (kBlocks > 1) v = hn::Min(v, blocks_before<1>(last_of_blocks(v)));
    if constexpr (kBlocks > 2) v = hn::Min(v, blocks_before<2>(last_of_blocks(v)));
    const Vec lowered = hn::Add(hn::Min(v, carried_), ramp_);
    carried_ = plus<Cell>(hn::Min(last_of_vector(last_of_blocks(v)), carried_), whole_vector_);
    return lowered;
  }

 private:
  using Words = hn::Repartition<std::int32_t, Cells>;
  using Bytes = hn::Repartition<std::uint8_t, Cells>;
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(Cells{}));
  static constexpr int kBlockLanes = 16 / static_cast<int>(sizeof(Cell));
  static constexpr int kBlocks = kLanes / kBlockLanes;
  static_assert(std::int64_t{kSteepest<Cell>} * kLanes <= kUnbounded<Cell>);

  static HWY_INLINE Vec ramp_of(std::int32_t repose) {
    HWY_ALIGN Cell lanes[hn::MaxLanes(Cells{})];
    for (int i = 0; i < kLanes; ++i) {
      const int place = kDirection == Direction::east ? i : kLanes - 1 - i;
      lanes[i] = static_cast<Cell>(place * repose);
    }
    return hn::Load(Cells{}, lanes);
  }
  /// Each lane takes the lane kCount before it in its block of 16 bytes.
  template <int kCount>
  HWY_INLINE Vec shifted(Vec v) const {
    constexpr int kBytes = kCount * static_cast<int>(sizeof(Cell));
    if constexpr (kDirection == Direction::east) {
      return hn::CombineShiftRightBytes<16 - kBytes>(Cells{}, v, unbounded_);
    } else {
      return hn::CombineShiftRightBytes<kBytes>(Cells{}, unbounded_, v);
    }
  }
  static HWY_INLINE Vec last_of_blocks(Vec v) {
    HWY_ALIGN static constexpr auto kLast = [] {
      std::array<std::uint8_t, 16> bytes{};
      for (std::size_t i = 0; i < bytes.size(); ++i) {
        const std::size_t within = i % sizeof(Cell);
        bytes[i] =
            static_cast<std::uint8_t>(kDirection == Direction::east ? 16 - sizeof(Cell) + within : within);
      }
      return bytes;
    }();
    return hn::TableLookupBytes(v, hn::BitCast(Cells{}, hn::LoadDup128(Bytes{}, kLast.data())));
  }
  /// Each block takes the block kCount before it.
  template <int kCount>
  HWY_INLINE Vec blocks_before(Vec v) const {
    if constexpr (2 * kCount == kBlocks) {
      return kDirection == Direction::east ? hn::ConcatLowerLower(Cells{}, v, unbounded_)
                                           : hn::ConcatUpperUpper(Cells{}, unbounded_, v);
    } else {
      const Words words;
      const auto lane = hn::Iota(words, 0);
      const auto shift = hn::Set(words, kDirection == Direction::east ? -4 * kCount : 4 * kCount);
      const auto from = hn::And(hn::Add(lane, shift), hn::Set(words, 4 * kBlocks - 1));
      const auto exists = kDirection == Direction::east
                              ? hn::Gt(lane, hn::Set(words, 4 * kCount - 1))
                              : hn::Lt(lane, hn::Set(words, 4 * (kBlocks - kCount)));
      const auto taken = hn::TableLookupLanes(hn::BitCast(words, v), hn::IndicesFromVec(words, from));
      return hn::BitCast(Cells{}, hn::IfThenElse(exists, taken, hn::BitCast(words, unbounded_)));
    }
  }
  /// The last block of last_of_blocks()'s result, in all blocks.
  static HWY_INLINE Vec last_of_vector(Vec last) {
    if constexpr (kBlocks == 1) {
      return last;
    } else {
      const Words words;
      const auto from = hn::Set(words, kDirection == Direction::east ? 4 * kBlocks - 1 : 0);
      return hn::BitCast(Cells{},
                         hn::TableLookupLanes(hn::BitCast(words, last), hn::IndicesFromVec(words, from)));
    }
  }

  Vec ramp_, whole_vector_, unbounded_, carried_;
};
#endif

/// own = min(own, minimum over the three adjacent cells of `other` + the rise to them), then the running
/// minimum. The chessboard metric has one rise for all three.
template <Metric kMetric, class Cell, Direction kDirection>
HWY_INLINE void settle_row(Cell* own, const Cell* other, std::size_t width, Rise rise,
                           RunningMinimum<Cell, kDirection>& minimum) {
  const hn::ScalableTag<Cell> d;
  const auto ramp = minimum.ramp();
  const auto step = hn::Sub(hn::Set(d, static_cast<Cell>(rise.straight)), ramp);
  const auto slant = hn::Sub(hn::Set(d, static_cast<Cell>(rise.diagonal)), ramp);
  minimum.begin_row();
  const std::size_t vectors = (width + hn::Lanes(d) - 1) / hn::Lanes(d);
  for (std::size_t v = 0; v < vectors; ++v) {
    const std::size_t x = (kDirection == Direction::east ? v : vectors - 1 - v) * hn::Lanes(d);
    const auto corners = hn::Min(hn::LoadU(d, other + x - 1), hn::LoadU(d, other + x + 1));
    const auto beside = [&]() HWY_ATTR {
      if constexpr (kMetric == Metric::chessboard) {
        return plus<Cell>(hn::Min(corners, hn::LoadU(d, other + x)), step);
      } else {
        return hn::Min(plus<Cell>(corners, slant), plus<Cell>(hn::LoadU(d, other + x), step));
      }
    }();
    hn::StoreU(minimum.next(hn::Min(hn::Sub(hn::LoadU(d, own + x), ramp), beside)), d, own + x);
  }
}

template <Metric kMetric, class Cell>
void settle_by(const PaddedRows<Cell>& rows, Rise rise) {
  RunningMinimum<Cell, Direction::east> eastward{rise.straight};
  for (std::size_t z = 0; z < rows.depth; ++z) {
    settle_row<kMetric>(rows.row(z), rows.row(z) - rows.stride, rows.width, rise, eastward);
  }
  RunningMinimum<Cell, Direction::west> westward{rise.straight};
  for (std::size_t z = rows.depth; z-- > 0;) {
    settle_row<kMetric>(rows.row(z), rows.row(z) + rows.stride, rows.width, rise, westward);
  }
}

template <class Cell>
void settle(const PaddedRows<Cell>& rows, Rise rise) {
  if (rise.straight == rise.diagonal) {
    settle_by<Metric::chessboard>(rows, rise);
  } else {
    settle_by<Metric::octagonal>(rows, rise);
  }
}

// The quotient is computed in floating point: t * room is exact below 2^53 in doubles and below 2^24 in
// floats. A quotient that is not an integer is at least 1 / S below the next one, so adding half a unit to
// the numerator never rounds past it; in floats if t and S are small enough: rounded twice, (t + 0.5) / 2^23
// is less than 0.5 / S.
constexpr std::int32_t kMaxThicknessInFloats_fx = 4095;  // a share of it is exact, too
[[nodiscard]] bool fits_floats(std::int32_t thickness_fx, std::int32_t max_slope_fx) {
  return thickness_fx <= kMaxThicknessInFloats_fx && max_slope_fx <= 1 << 20 &&
         std::int64_t{thickness_fx} * max_slope_fx <= 1 << 21;
}

template <class D>
HWY_INLINE hn::VFromD<D> from_ints(D d, hn::VFromD<hn::Rebind<std::int32_t, D>> whole) {
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(std::int32_t)) {
    return hn::ConvertTo(d, whole);
  } else {
    return hn::PromoteTo(d, whole);
  }
}
/// Rounds down non-negative numbers.
template <class D>
HWY_INLINE hn::VFromD<hn::Rebind<std::int32_t, D>> to_ints(D /*d*/, hn::VFromD<D> real) {
  const hn::Rebind<std::int32_t, D> ints;
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(std::int32_t)) {
    return hn::ConvertTo(ints, real);
  } else {
    return hn::DemoteTo(ints, real);
  }
}

/// `thickness_at` returns t at a vector's columns.
template <class Real, class Cell, class Thickness>
HWY_INLINE void start_with(const std::int32_t* slope, std::size_t width, std::int32_t max_slope_fx,
                           const Thickness& thickness_at, Cell* cells) {
  const Real part = Real{1} / static_cast<Real>(max_slope_fx);
  over_row(hn::ScalableTag<Real>{}, width, [=](auto d, std::size_t i) HWY_ATTR {
    const hn::Rebind<std::int32_t, decltype(d)> ints;
    const auto steepness = hn::Min(hn::LoadU(ints, slope + i), hn::Set(ints, max_slope_fx));
    const auto room = from_ints(d, hn::Sub(hn::Set(ints, max_slope_fx), steepness));
    const auto product = hn::Add(hn::Mul(room, thickness_at(d, i)), hn::Set(d, Real{0.5}));
    const auto quotient = to_ints(d, hn::Mul(product, hn::Set(d, part)));
    const hn::Rebind<Cell, decltype(d)> out;
    if constexpr (sizeof(Cell) == sizeof(std::int32_t)) {
      hn::StoreU(quotient, out, cells + i);
    } else {
      hn::StoreU(hn::DemoteTo(out, quotient), out, cells + i);
    }
  });
}

template <class Real, class Cell>
void start_by(const std::int32_t* slope, std::size_t width, std::int32_t thickness_fx,
              std::int32_t max_slope_fx, Cell* cells) {
  const auto thickness = static_cast<Real>(thickness_fx);
  start_with<Real>(
      slope, width, max_slope_fx, [=](auto d, std::size_t) HWY_ATTR { return hn::Set(d, thickness); }, cells);
}

#if !HWY_HAVE_FLOAT64
/// The same column by column. `share` is null if every column has the whole thickness.
template <class Cell>
void start_in_doubles(const std::int32_t* slope, const std::int32_t* share, std::size_t width,
                      double thickness, std::int32_t max_slope_fx, Cell* cells) {
  const double part = 1.0 / max_slope_fx;
  for (std::size_t i = 0; i < width; ++i) {
    const double room = max_slope_fx - std::min(slope[i], max_slope_fx);
    const double shared = share == nullptr ? thickness : std::floor(share[i] * thickness);
    const auto quotient = static_cast<std::int32_t>((room * shared + 0.5) * part);
    cells[i] = static_cast<Cell>(std::min<std::int32_t>(quotient, std::numeric_limits<Cell>::max()));
  }
}
#endif

template <class Cell>
void start(const std::int32_t* slope, std::size_t width, std::int32_t thickness_fx, std::int32_t max_slope_fx,
           Cell* cells) {
  if (fits_floats(thickness_fx, max_slope_fx)) {
    start_by<float>(slope, width, thickness_fx, max_slope_fx, cells);
  } else {
#if HWY_HAVE_FLOAT64
    start_by<double>(slope, width, thickness_fx, max_slope_fx, cells);
#else
    start_in_doubles(slope, nullptr, width, thickness_fx, max_slope_fx, cells);
#endif
  }
}

// t * share is exact, and so is its quotient by a power of two.
template <class Real, class Cell>
void start_shared_by(const std::int32_t* slope, const std::int32_t* share, std::size_t width,
                     std::int32_t thickness_fx, std::int32_t whole, std::int32_t max_slope_fx, Cell* cells) {
  const Real thickness = static_cast<Real>(thickness_fx) / static_cast<Real>(whole);
  start_with<Real>(
      slope, width, max_slope_fx,
      [=](auto d, std::size_t i) HWY_ATTR {
        const hn::Rebind<std::int32_t, decltype(d)> ints;
        const auto exact = hn::Mul(from_ints(d, hn::LoadU(ints, share + i)), hn::Set(d, thickness));
        return from_ints(d, to_ints(d, exact));
      },
      cells);
}

constexpr std::int32_t kMaxShareInFloats = 1 << 12;

template <class Cell>
void start_shared(const std::int32_t* slope, const std::int32_t* share, std::size_t width,
                  std::int32_t thickness_fx, std::int32_t whole, std::int32_t max_slope_fx, Cell* cells) {
  if (fits_floats(thickness_fx, max_slope_fx) && whole <= kMaxShareInFloats) {
    start_shared_by<float>(slope, share, width, thickness_fx, whole, max_slope_fx, cells);
  } else {
#if HWY_HAVE_FLOAT64
    start_shared_by<double>(slope, share, width, thickness_fx, whole, max_slope_fx, cells);
#else
    start_in_doubles(slope, share, width, static_cast<double>(thickness_fx) / whole, max_slope_fx, cells);
#endif
  }
}

template <class Cell>
bool walls(const std::int32_t* slope, std::size_t width, std::int32_t wall_fx, std::int32_t elsewhere,
           Cell* cells) {
  bool any = false;
  over_row(hn::ScalableTag<std::int32_t>{}, width, [&](auto d, std::size_t x) HWY_ATTR {
    const auto steep = hn::Gt(hn::LoadU(d, slope + x), hn::Set(d, wall_fx));
    any |= !hn::AllFalse(d, steep);
    const auto cell = hn::IfThenZeroElse(steep, hn::Set(d, elsewhere));
    if constexpr (sizeof(Cell) == sizeof(std::int32_t)) {
      hn::StoreU(cell, d, cells + x);
    } else {
      const hn::Rebind<Cell, decltype(d)> narrow;
      hn::StoreU(hn::DemoteTo(narrow, cell), narrow, cells + x);
    }
  });
  return any;
}

}  // namespace

constexpr SettleKernels kSettle{start<std::int16_t>,        start<std::int32_t>, start_shared<std::int16_t>,
                                start_shared<std::int32_t>, walls<std::int16_t>, walls<std::int32_t>,
                                settle<std::int16_t>,       settle<std::int32_t>};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const SettleKernels& settle_kernels(InstructionSet set) {
  static constexpr const SettleKernels* kTables[] = TALUS_TABLES(kSettle);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
