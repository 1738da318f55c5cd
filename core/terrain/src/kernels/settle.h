// Settling as a distance transform: two raster passes over a padded field.
//
// Cells are int16 if all thicknesses are at most 32767 subvoxels, which doubles a vector's cells; otherwise
// int32.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

/// Exceeds any thickness. Surrounds a field, so that its edges need no special cases. Sums with it do not
/// overflow (int16 sums saturate).
template <class Cell>
inline constexpr Cell kUnbounded = Cell{1} << 30;
template <>
inline constexpr std::int16_t kUnbounded<std::int16_t> = std::numeric_limits<std::int16_t>::max();

/// The steepest repose for such cells: its sum over a vector, 32 cells at most, still fits a cell. No limit
/// in practice for int32, as thicknesses are at most 2^20.
template <class Cell>
inline constexpr std::int32_t kSteepest = kUnbounded<Cell> / 32;

/// Rows of a field surrounded by unbounded cells: before each row, after it up to the stride, and one row
/// above and below. `cells` points at the first cell of the first row.
template <class Cell>
struct PaddedRows {
  Cell* cells = nullptr;
  std::size_t stride = 0;
  std::size_t width = 0;
  std::size_t depth = 0;

  [[nodiscard]] Cell* row(std::size_t z) const { return cells + z * stride; }
};

/// The maximum height of a cell above its neighbours. Two passes are exact if straight <= diagonal <= 2
/// straight. The distance is the chessboard's if both are equal, otherwise octagonal.
struct Rise {
  std::int32_t straight;
  std::int32_t diagonal;
};

struct SettleKernels {
  /// Eq. 3: floor(t * (S - slope) / S), 0 if the slope is steeper than S.
  void (*start_int16)(const std::int32_t* slope, std::size_t width, std::int32_t thickness_fx,
                      std::int32_t max_slope_fx, std::int16_t* cells);
  void (*start_int32)(const std::int32_t* slope, std::size_t width, std::int32_t thickness_fx,
                      std::int32_t max_slope_fx, std::int32_t* cells);
  /// Eq. 3 with floor(t * share / whole) for t; `whole` is a power of two.
  void (*start_shared_int16)(const std::int32_t* slope, const std::int32_t* share, std::size_t width,
                             std::int32_t thickness_fx, std::int32_t whole, std::int32_t max_slope_fx,
                             std::int16_t* cells);
  void (*start_shared_int32)(const std::int32_t* slope, const std::int32_t* share, std::size_t width,
                             std::int32_t thickness_fx, std::int32_t whole, std::int32_t max_slope_fx,
                             std::int32_t* cells);
  /// 0 where the slope is above wall_fx, else `elsewhere`. Returns true if there is such a slope.
  bool (*walls_int16)(const std::int32_t* slope, std::size_t width, std::int32_t wall_fx,
                      std::int32_t elsewhere, std::int16_t* cells);
  bool (*walls_int32)(const std::int32_t* slope, std::size_t width, std::int32_t wall_fx,
                      std::int32_t elsewhere, std::int32_t* cells);
  /// Lowers every cell to its value at rest: at most `rise` above each of its 8 neighbours. rise.straight
  /// must be at most kSteepest<Cell>. Cells between a row's width and its stride become unspecified.
  void (*settle_int16)(const PaddedRows<std::int16_t>& rows, Rise rise);
  void (*settle_int32)(const PaddedRows<std::int32_t>& rows, Rise rise);
};

[[nodiscard]] const SettleKernels& settle_kernels(InstructionSet set);

}  // namespace talus::terrain
