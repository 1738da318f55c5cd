#include "columns.h"

#include <talus/voxel/coords.h>

#include <talus/vectors/tables.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/columns.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <talus/vectors/vectors-inl.h>

HWY_BEFORE_NAMESPACE();
namespace talus::terrain::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using talus::HWY_NAMESPACE::over_row;

using Ints = hn::ScalableTag<std::int32_t>;

void slope(const std::int32_t* north, const std::int32_t* own, const std::int32_t* south, std::size_t width,
           std::int32_t* out) {
  over_row(Ints{}, width, [=](auto d, std::size_t x) HWY_ATTR {
    // The greatest difference is to the lowest or the highest of the nine.
    const auto height = hn::LoadU(d, own + x + 1);
    auto low = height;
    auto high = height;
    for (const std::int32_t* row : {north + x, own + x, south + x}) {
      const auto west = hn::LoadU(d, row);
      const auto middle = hn::LoadU(d, row + 1);
      const auto east = hn::LoadU(d, row + 2);
      low = hn::Min(low, hn::Min(hn::Min(west, middle), east));
      high = hn::Max(high, hn::Max(hn::Max(west, middle), east));
    }
    hn::StoreU(hn::Max(hn::Sub(height, low), hn::Sub(high, height)), d, out + x);
  });
}

void cut(const std::int32_t* tops, std::size_t stride, std::int32_t floor_row, std::uint8_t* rows) {
  const hn::CappedTag<std::int32_t, kChunkSize> d;
  const hn::Rebind<std::uint8_t, decltype(d)> bytes;
  const auto rounding = hn::Set(d, 127);
  const auto floor = hn::Set(d, floor_row);
  const auto most = hn::Set(d, kChunkSize);
  for (int z = 0; z < kChunkSize; ++z, tops += stride) {
    for (std::size_t x = 0; x < kChunkSize; x += hn::Lanes(d), rows += hn::Lanes(d)) {
      const auto row = hn::ShiftRight<8>(hn::Add(hn::LoadU(d, tops + x), rounding));
      // DemoteTo clamps negative rows to 0. Rows above must be clamped before it: some targets drop the high
      // bits of numbers of more than 15 bits.
      hn::StoreU(hn::DemoteTo(bytes, hn::Min(hn::Sub(row, floor), most)), bytes, rows);
    }
  }
}

template <class Cell>
void lower(const std::int32_t* top, const Cell* thickness, std::size_t width, std::int32_t* lowered) {
  over_row(Ints{}, width, [=](auto d, std::size_t x) HWY_ATTR {
    const hn::Rebind<Cell, decltype(d)> cells;
    const auto thick = hn::LoadU(cells, thickness + x);
    const auto below = [&] {
      if constexpr (sizeof(Cell) == sizeof(std::int32_t)) {
        return hn::Sub(hn::LoadU(d, top + x), thick);
      } else {
        return hn::Sub(hn::LoadU(d, top + x), hn::PromoteTo(d, thick));
      }
    }();
    hn::StoreU(hn::Max(below, hn::Zero(d)), d, lowered + x);
  });
}

void cut_at(const std::int32_t* most, int shift, std::size_t width, std::int32_t* top) {
  over_row(Ints{}, width, [=](auto d, std::size_t x) HWY_ATTR {
    const auto highest = hn::ShiftRightSame(hn::LoadU(d, most + x), shift);
    hn::StoreU(hn::Min(hn::LoadU(d, top + x), highest), d, top + x);
  });
}

}  // namespace

constexpr ColumnKernels kColumns{slope, cut, lower<std::int16_t>, lower<std::int32_t>, cut_at};

}  // namespace talus::terrain::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace talus::terrain {

const ColumnKernels& column_kernels(InstructionSet set) {
  static constexpr const ColumnKernels* kTables[] = TALUS_TABLES(kColumns);
  return *kTables[static_cast<std::size_t>(set)];
}

}  // namespace talus::terrain
#endif
