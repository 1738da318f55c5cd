// Operations on single columns: slope, planes, voxel rows.
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

struct ColumnKernels {
  /// Eq. 1 for columns 1 to width of three rows of width + 2.
  void (*slope)(const std::int32_t* north, const std::int32_t* own, const std::int32_t* south,
                std::size_t width, std::int32_t* out);
  /// The boundary rows of 32 rows of 32 columns relative to `floor_row`, clamped to 0 to 32 (boundary_row.h).
  /// Rows of `tops` are `stride` apart; `rows` is contiguous.
  void (*cut)(const std::int32_t* tops, std::size_t stride, std::int32_t floor_row, std::uint8_t* rows);
  /// lowered = max(top - thickness, 0).
  void (*lower_int16)(const std::int32_t* top, const std::int16_t* thickness, std::size_t width,
                      std::int32_t* lowered);
  void (*lower_int32)(const std::int32_t* top, const std::int32_t* thickness, std::size_t width,
                      std::int32_t* lowered);
  /// top = min(top, most >> shift).
  void (*cut_at)(const std::int32_t* most, int shift, std::size_t width, std::int32_t* top);
};

[[nodiscard]] const ColumnKernels& column_kernels(InstructionSet set);

}  // namespace talus::terrain
