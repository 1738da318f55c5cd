// The numbers of a batch's coded voxels side by side, by instructions that some processors with AVX-512 have
// and others lack (VBMI2 and GFNI); volume_waves-inl.h does it row by row for all.
#pragma once

#include <cstddef>
#include <cstdint>

namespace talus::codec {

inline constexpr std::size_t kPackRows = 16;

/// Masks of sixteen rows: bit x is of column x.
struct PackedRows {
  const std::uint32_t* coded;  // which columns have numbers
  std::uint32_t coded_rows;    // bit i: row i has any
};

struct VolumePack {
  /// Appends a byte for each coded voxel, row by row; gives how many. `bits`: kPackRows masks for each of
  /// eight bits, from the lowest. May write 32 bytes past the last.
  std::size_t (*contexts)(const PackedRows& rows, const std::uint32_t* bits, std::uint8_t* out);
  /// The same of numbers of two bits.
  void (*symbols)(const PackedRows& rows, const std::uint32_t* low, const std::uint32_t* high,
                  std::uint8_t* out);
};

/// Null where this processor has no such instructions.
[[nodiscard]] const VolumePack* volume_pack();

}  // namespace talus::codec
