// Settling as a distance transform: two raster passes over a padded field.
//
// Cells are int16 where no thickness passes 32767 subvoxels, which doubles what a vector holds, else int32.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

/// Thicker than anything: what stands around a field, so that its edges need no cases of their own. A sum
/// with it does not overflow (int16 sums saturate).
template <class Cell>
inline constexpr Cell kUnbounded = Cell{1} << 30;
template <>
inline constexpr std::int16_t kUnbounded<std::int16_t> = std::numeric_limits<std::int16_t>::max();

/// The steepest repose that settles in such cells: what it adds up to from one vector to the next, 32 cells
/// at most, still fits one. In int32 it binds nothing, as no thickness is above 2^20.
template <class Cell>
inline constexpr std::int32_t kSteepest = kUnbounded<Cell> / 32;

/// Rows of a field with unbounded cells around: before each row, after it up to the stride, and one row
/// above and below. `cells` points at the first cell of the first row.
template <class Cell>
struct PaddedRows {
  Cell* cells = nullptr;
  std::size_t stride = 0;
  std::size_t width = 0;
  std::size_t depth = 0;

  [[nodiscard]] Cell* row(std::size_t z) const { return cells + z * stride; }
};

/// How much a cell may stand above its neighbours. Two passes are exact where straight <= diagonal <= 2
/// straight; the distance is then the chessboard's where both are the same, and else an octagon's.
struct Rise {
  std::int32_t straight;
  std::int32_t diagonal;
};

struct SettleKernels {
  /// Eq. 3: floor(t * (S - slope) / S), 0 where the slope is steeper than S.
  void (*start_int16)(const std::int32_t* slope, std::size_t width, std::int32_t thickness_fx,
                      std::int32_t max_slope_fx, std::int16_t* cells);
  void (*start_int32)(const std::int32_t* slope, std::size_t width, std::int32_t thickness_fx,
                      std::int32_t max_slope_fx, std::int32_t* cells);
  /// The same of floor(t * share / whole), where `whole` is a power of two.
  void (*start_shared_int16)(const std::int32_t* slope, const std::int32_t* share, std::size_t width,
                             std::int32_t thickness_fx, std::int32_t whole, std::int32_t max_slope_fx,
                             std::int16_t* cells);
  void (*start_shared_int32)(const std::int32_t* slope, const std::int32_t* share, std::size_t width,
                             std::int32_t thickness_fx, std::int32_t whole, std::int32_t max_slope_fx,
                             std::int32_t* cells);
  /// 0 where the slope is above wall_fx, else `elsewhere`. Whether there is such a slope.
  bool (*walls_int16)(const std::int32_t* slope, std::size_t width, std::int32_t wall_fx,
                      std::int32_t elsewhere, std::int16_t* cells);
  bool (*walls_int32)(const std::int32_t* slope, std::size_t width, std::int32_t wall_fx,
                      std::int32_t elsewhere, std::int32_t* cells);
  /// Lowers every cell to what rests there: at most `rise` above each of its 8 neighbours. rise.straight
  /// is kSteepest<Cell> or less. Leaves numbers without meaning between a row's width and its stride.
  void (*settle_int16)(const PaddedRows<std::int16_t>& rows, Rise rise);
  void (*settle_int32)(const PaddedRows<std::int32_t>& rows, Rise rise);
};

[[nodiscard]] const SettleKernels& settle_kernels(InstructionSet set);

}  // namespace talus::terrain
