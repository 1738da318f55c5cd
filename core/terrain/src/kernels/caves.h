// Caves, one row of columns at a time (docs/DESIGN.md, "Caves").
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

/// Rules by which a column with air is roofed, open, or solid after all, at a level.
struct RoofRules {
  int level = 0;
  std::int32_t loose_fx = 0;  // total thickness of loose material
  std::int32_t sunk_fx = 0;   // maximum depth of ground below H if water is near
  std::int32_t min_rows = 0;  // minimum rows of a roof that holds
  bool shore = false;         // true if water is near the row
  std::int32_t sea_fx = 0;    // in subvoxels of the level
};

/// Level 0's H over three rows. `north` and `south` are null without a shore; with one, all three rows also
/// have a column before and one after the judged columns.
struct HeightsAround {
  const std::int32_t* north = nullptr;
  const std::int32_t* own = nullptr;
  const std::int32_t* south = nullptr;
};

/// Rows of the judged columns.
struct JudgedRows {
  const std::int32_t* floor_fx = nullptr;
  std::int32_t* roof_fx = nullptr;   // 0 without air; judge() stores the surface in open columns
  std::int32_t* roof_row = nullptr;  // boundary row of the roof in a roofed column, else kFarBelow
  std::int32_t* rock_row = nullptr;  // row below which rock is surely solid; kFarBelow in an open column
  std::uint64_t* roofed = nullptr;   // one bit per column, with room for 64 more
  std::uint64_t* open = nullptr;     // one bit per column, with room for 64 more
};
inline constexpr std::int32_t kFarBelow = -(1 << 28);

struct CaveKernels {
  /// Returns the range of columns of `within` that contains all air.
  ColumnRange (*find)(const CavePlan& plan, const CaveNoises& noises, ColumnRange within);
  /// Computes the air of the columns, in subvoxels of the level; both 0 without air.
  void (*shape)(const CavePlan& plan, const CaveNoises& noises, ColumnRange columns, int level,
                std::int32_t* floor_fx, std::int32_t* roof_fx);
  /// REQUIRES width > 0.
  std::int32_t (*lowest)(const std::int32_t* heights_fx, std::size_t width);
  /// Only sets bits.
  void (*judge)(const RoofRules& rules, const HeightsAround& heights, std::size_t width,
                const JudgedRows& rows);
  /// Sets the bits of columns in which rows a and b of JudgedRows have a common row of roof rock.
  void (*touch)(const std::int32_t* roof_a, const std::int32_t* rock_a, const std::int32_t* roof_b,
                const std::int32_t* rock_b, std::size_t width, std::uint64_t* touching);
};

[[nodiscard]] const CaveKernels& cave_kernels(InstructionSet set);

}  // namespace talus::terrain
