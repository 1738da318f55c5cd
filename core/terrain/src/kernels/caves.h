// Caves, a row of columns at a time (docs/DESIGN.md, "Caves").
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/vectors/instruction_set.h>

#include "features/cave_plan.h"
#include "kernels/column_range.h"

namespace talus::terrain {

/// Rows of noise, padded.
struct CaveNoises {
  const float* tunnels = nullptr;
  const float* chambers = nullptr;
  const float* climb = nullptr;
};

/// What decides whether a column with air is roofed, open or solid after all, at a level.
struct RoofRules {
  int level = 0;
  std::int32_t loose_fx = 0;    // all that can be loose
  std::int32_t sunk_fx = 0;     // how far under H ground may come to lie, where water is near
  std::int32_t least_rows = 0;  // of a roof that holds
  bool shore = false;           // whether water is near the row
  std::int32_t sea_fx = 0;      // at the level
};

/// Level 0's H over three rows. Those beside the row's own are null where there is no shore; else all three
/// have a column before and one past the columns.
struct HeightsAround {
  const std::int32_t* north = nullptr;
  const std::int32_t* own = nullptr;
  const std::int32_t* south = nullptr;
};

/// Rows of the judged columns.
struct JudgedRows {
  const std::int32_t* floor_fx = nullptr;
  std::int32_t* roof_fx = nullptr;   // 0 where there is no air; becomes the surface in an open column
  std::int32_t* roof_row = nullptr;  // of a roofed column, else kFarBelow
  std::int32_t* rock_row = nullptr;  // where solid rock surely ends; kFarBelow in an open one
  std::uint64_t* roofed = nullptr;   // a bit a column, and room for 64 more
  std::uint64_t* open = nullptr;     // likewise
};
inline constexpr std::int32_t kFarBelow = -(1 << 28);

struct CaveKernels {
  /// Columns of `within` between which all air is.
  ColumnRange (*find)(const CavePlan& plan, const CaveNoises& noises, ColumnRange within);
  /// The air of these columns, in subvoxels of the level; both 0 where there is none.
  void (*shape)(const CavePlan& plan, const CaveNoises& noises, ColumnRange columns, int level,
                std::int32_t* floor_fx, std::int32_t* roof_fx);
  /// REQUIRES width > 0.
  std::int32_t (*lowest)(const std::int32_t* heights_fx, std::size_t width);
  /// Sets bits, and clears none.
  void (*judge)(const RoofRules& rules, const HeightsAround& heights, std::size_t width,
                const JudgedRows& rows);
  /// The same where a row is rock in both roofs: of roof_row and rock_row of JudgedRows.
  void (*touch)(const std::int32_t* roof_a, const std::int32_t* rock_a, const std::int32_t* roof_b,
                const std::int32_t* rock_b, std::size_t width, std::uint64_t* touching);
};

[[nodiscard]] const CaveKernels& cave_kernels(InstructionSet set);

}  // namespace talus::terrain
