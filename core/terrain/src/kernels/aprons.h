// Talus aprons, row by row (docs/DESIGN.md "Talus aprons").
//
// A step that reads neighbours takes rows that begin one column before `out` and are two columns longer, and
// writes `width` columns. If rows come from one field, `stride` is the distance between them.
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/vectors/instruction_set.h>

#include "kernels/column_range.h"

namespace talus::terrain {

/// Higher than any ground; sums with it do not overflow.
inline constexpr std::int32_t kNoGround_fx = std::int32_t{1} << 30;

/// A row of columns before aprons spread over it; see ApronKernels::begin.
struct ApronRows {
  std::int32_t* floor;    // H if scree may lie there, else kNoGround_fx
  std::int32_t* top;      // top of an apron, or -kNoGround_fx
  std::int32_t* surface;  // H; in walls, the top of the apron leaning on them
};

struct ApronSupply {
  std::int32_t wall_fx;
  std::int32_t max_fx;
  std::int32_t share_q8;
  std::int32_t enough_fx;  // height of rock above a foot that yields max_fx
};

struct ApronKernels {
  /// Sets two rows to H, or to kNoGround_fx at walls. Returns the range of columns that contains all walls.
  ColumnRange (*start_feet)(const std::int32_t* height, const std::int32_t* slope, std::size_t width,
                            std::int32_t wall_fx, std::int32_t* foot, std::int32_t* next);
  /// In walls the lowest foot of the nine columns, or of five without `diagonals`; elsewhere unchanged.
  /// `feet` is the row before the middle one.
  void (*descend)(const std::int32_t* feet, std::size_t stride, const std::int32_t* slope, std::size_t width,
                  std::int32_t wall_fx, bool diagonals, std::int32_t* foot);
  /// sum += other.
  void (*add)(const std::int32_t* other, std::size_t width, std::int32_t* sum);
  void (*halve)(std::size_t width, int times, std::int32_t* sum);
  /// Starts aprons from `mean`, the means of H around. Returns the range of columns with starts.
  ColumnRange (*begin)(const std::int32_t* height, const std::int32_t* slope, const std::int32_t* foot,
                       const std::int32_t* mean, std::size_t width, const ApronSupply& supply,
                       const ApronRows& out);
  /// One step outward: a top is c_fx below its highest neighbour in a row or column, or diagonal_fx below its
  /// highest diagonal neighbour (ignored if diagonal_fx is 0), whichever is higher, and at most thickest_fx
  /// above the floor. Removes tops in walls. `tops` is the row before the middle one.
  void (*spread)(const std::int32_t* tops, std::size_t stride, const std::int32_t* floor, std::size_t width,
                 std::int32_t c_fx, std::int32_t diagonal_fx, std::int32_t thickest_fx, std::int32_t* top);
  /// surface = max(surface, top).
  void (*cover)(const std::int32_t* top, std::size_t width, std::int32_t* surface);
  /// Computes H' from the nine columns of `surfaces`, whose first row is the one before the middle one.
  void (*finish)(const std::int32_t* surfaces, std::size_t stride, const std::int32_t* height,
                 const std::int32_t* top, std::size_t width, std::int32_t c_fx, std::int32_t bare_fx,
                 std::int32_t* raised);
};

[[nodiscard]] const ApronKernels& apron_kernels(InstructionSet set);

}  // namespace talus::terrain
