#include "loose/settle_grid.h"

#include <algorithm>

#include <talus/vectors/tables.h>

namespace talus::terrain {
namespace {

// Makes everything around the rows, and between a row's width and the next row, unbounded.
template <class Cell>
PaddedRows<Cell> padded_rows(AlignedVector<Cell>& cells, std::size_t width, std::size_t depth) {
  PaddedRows<Cell> rows;
  rows.width = width;
  rows.depth = depth;
  rows.stride = padded(width);
  const std::size_t size = kPadding + (depth + 2) * rows.stride;
  if (cells.size() < size) cells.resize(size);
  std::fill_n(cells.begin(), kPadding + rows.stride, kUnbounded<Cell>);
  std::fill_n(cells.begin() + static_cast<std::ptrdiff_t>(kPadding + (depth + 1) * rows.stride), rows.stride,
              kUnbounded<Cell>);
  rows.cells = cells.data() + kPadding + rows.stride;
  for (std::size_t z = 0; z < depth; ++z) {
    std::fill_n(rows.row(z) + width, rows.stride - width, kUnbounded<Cell>);
  }
  return rows;
}

}  // namespace

void SettleGrid::reshape(int width, int depth, std::int32_t max_fx) {
  narrow_ = max_fx < kUnbounded<std::int16_t>;
  const auto w = static_cast<std::size_t>(width);
  const auto d = static_cast<std::size_t>(depth);
  if (narrow_) {
    narrow_rows_ = padded_rows(narrow_cells_, w, d);
  } else {
    wide_rows_ = padded_rows(wide_cells_, w, d);
  }
}

void SettleGrid::start(const Field& slope, std::int32_t thickness_fx, std::int32_t max_slope_fx) {
  begin(slope.width, slope.depth, thickness_fx);
  for (int z = 0; z < slope.depth; ++z) start_row(z, slope.row(z).data(), thickness_fx, max_slope_fx);
}

void SettleGrid::start_row(int z, const std::int32_t* slope, std::int32_t thickness_fx,
                           std::int32_t max_slope_fx) {
  const auto row = static_cast<std::size_t>(z);
  if (narrow_) {
    kernels_->start_int16(slope, narrow_rows_.width, thickness_fx, max_slope_fx, narrow_rows_.row(row));
  } else {
    kernels_->start_int32(slope, wide_rows_.width, thickness_fx, max_slope_fx, wide_rows_.row(row));
  }
}

void SettleGrid::start_row(int z, const std::int32_t* slope, const std::int32_t* share,
                           std::int32_t thickness_fx, std::int32_t whole, std::int32_t max_slope_fx) {
  const auto row = static_cast<std::size_t>(z);
  if (narrow_) {
    kernels_->start_shared_int16(slope, share, narrow_rows_.width, thickness_fx, whole, max_slope_fx,
                                 narrow_rows_.row(row));
  } else {
    kernels_->start_shared_int32(slope, share, wide_rows_.width, thickness_fx, whole, max_slope_fx,
                                 wide_rows_.row(row));
  }
}

void SettleGrid::start(const Field& thickness) {
  const auto thickest = std::max_element(thickness.values.begin(), thickness.values.end());
  reshape(thickness.width, thickness.depth, thickest == thickness.values.end() ? 0 : *thickest);
  for (int z = 0; z < thickness.depth; ++z) {
    const auto row = static_cast<std::size_t>(z);
    const auto from = thickness.row(z);
    if (narrow_) {
      std::transform(from.begin(), from.end(), narrow_rows_.row(row),
                     [](std::int32_t value) { return static_cast<std::int16_t>(value); });
    } else {
      std::copy(from.begin(), from.end(), wide_rows_.row(row));
    }
  }
}

bool SettleGrid::start_at_walls(const Field& slope, int ring, std::int32_t wall_fx, std::int32_t elsewhere) {
  reshape(slope.width - 2 * ring, slope.depth - 2 * ring, elsewhere);
  bool any = false;
  for (int z = ring; z < slope.depth - ring; ++z) {
    const auto row = static_cast<std::size_t>(z - ring);
    const std::int32_t* const from = slope.row(z).data() + ring;
    any |= narrow_
               ? kernels_->walls_int16(from, narrow_rows_.width, wall_fx, elsewhere, narrow_rows_.row(row))
               : kernels_->walls_int32(from, wide_rows_.width, wall_fx, elsewhere, wide_rows_.row(row));
  }
  return any;
}

void SettleGrid::settle(Rise rise) {
  if (rise.straight > kSteepest<std::int16_t>) widen();
  if (narrow_) {
    kernels_->settle_int16(narrow_rows_, rise);
  } else {
    constexpr std::int32_t kMaxRise = kSteepest<std::int32_t>;
    kernels_->settle_int32(wide_rows_,
                           {std::min(rise.straight, kMaxRise), std::min(rise.diagonal, 2 * kMaxRise)});
  }
}

void SettleGrid::widen() {
  if (!narrow_) return;
  wide_rows_ = padded_rows(wide_cells_, narrow_rows_.width, narrow_rows_.depth);
  for (std::size_t z = 0; z < wide_rows_.depth; ++z) {
    std::copy_n(narrow_rows_.row(z), wide_rows_.width, wide_rows_.row(z));
  }
  narrow_ = false;
}

}  // namespace talus::terrain
