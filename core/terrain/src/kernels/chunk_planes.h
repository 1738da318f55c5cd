// Operations on a chunk's planes: rows of 0 to 32, one byte per column (column_index).
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

/// All arrays except `looks` have kChunkArea bytes.
struct ChunkPlaneKernels {
  /// `out` must be neither `a` nor `b`.
  void (*lower_of)(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* out);
  void (*higher_of)(const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* out);
  /// Counts columns with bottom <= from < to <= top.
  std::size_t (*count_inside)(const std::uint8_t* from, const std::uint8_t* to, const std::uint8_t* bottom,
                              const std::uint8_t* top);
  /// Returns true if a column has from < to.
  bool (*any)(const std::uint8_t* from, const std::uint8_t* to);
  /// low = from and high = to if from < to, else both = other.
  void (*interval)(const std::uint8_t* from, const std::uint8_t* to, const std::uint8_t* other,
                   std::uint8_t* low, std::uint8_t* high);
  /// rows = plane in columns with look `look`. Rows of `looks` are `stride` apart.
  void (*raise_where)(const std::uint8_t* looks, std::size_t stride, std::uint8_t look,
                      const std::uint8_t* plane, std::uint8_t* rows);
};

[[nodiscard]] const ChunkPlaneKernels& chunk_plane_kernels(InstructionSet set);

}  // namespace talus::terrain
