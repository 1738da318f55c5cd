// Talus aprons, row by row (docs/DESIGN.md "Talus aprons").
//
// A step that looks at neighbours reads rows that begin one column before `out` does and are two longer, and
// writes `width` columns. Where rows come from one field, `stride` leads from one to the next.
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/vectors/instruction_set.h>

#include "kernels/column_range.h"

namespace talus::terrain {

/// Higher than any ground; a sum with it does not overflow.
inline constexpr std::int32_t kNoGround_fx = std::int32_t{1} << 30;

/// What a row of columns becomes before aprons spread over it; see ApronKernels::begin.
struct ApronRows {
  std::int32_t* floor;    // H where scree may lie, else kNoGround_fx
  std::int32_t* top;      // of an apron, or -kNoGround_fx
  std::int32_t* surface;  // H; in walls, the top of the apron that leans on them
};

struct ApronSupply {
  std::int32_t wall_fx;
  std::int32_t most_fx;
  std::int32_t share_q8;
  std::int32_t enough_fx;  // how much rock above a foot gives most_fx
};

struct ApronKernels {
  /// foot = H where the slope is no wall's, else kNoGround_fx, in two rows. Columns among which all walls
  /// are.
  ColumnRange (*start_feet)(const std::int32_t* height, const std::int32_t* slope, std::size_t width,
                            std::int32_t wall_fx, std::int32_t* foot, std::int32_t* next);
  /// In walls the lowest foot of the nine columns, or without those along diagonals; elsewhere what it was.
  /// `feet` is the row before the middle one.
  void (*descend)(const std::int32_t* feet, std::size_t stride, const std::int32_t* slope, std::size_t width,
                  std::int32_t wall_fx, bool diagonals, std::int32_t* foot);
  /// sum += other.
  void (*add)(const std::int32_t* other, std::size_t width, std::int32_t* sum);
  void (*halve)(std::size_t width, int times, std::int32_t* sum);
  /// From the means of H around. Columns among which all are where an apron begins.
  ColumnRange (*begin)(const std::int32_t* height, const std::int32_t* slope, const std::int32_t* foot,
                       const std::int32_t* mean, std::size_t width, const ApronSupply& supply,
                       const ApronRows& out);
  /// One step outward: at least c lower than a neighbour in a row or column, diagonal_fx than the others,
  /// which are not looked at where that is 0, and at most thickest_fx above the floor. Tops in walls end with
  /// it. `tops` is the row before the middle one.
  void (*spread)(const std::int32_t* tops, std::size_t stride, const std::int32_t* floor, std::size_t width,
                 std::int32_t c_fx, std::int32_t diagonal_fx, std::int32_t thickest_fx, std::int32_t* top);
  /// surface = max(surface, top).
  void (*cover)(const std::int32_t* top, std::size_t width, std::int32_t* surface);
  /// H', from the nine columns of `surfaces`, whose first row is that before the middle one.
  void (*finish)(const std::int32_t* surfaces, std::size_t stride, const std::int32_t* height,
                 const std::int32_t* top, std::size_t width, std::int32_t c_fx, std::int32_t bare_fx,
                 std::int32_t* raised);
};

[[nodiscard]] const ApronKernels& apron_kernels(InstructionSet set);

}  // namespace talus::terrain
