// Conversion of planes to symbols and back, a row of 32 columns at a time, one implementation per instruction
// set: FORMAT.md, "Layered".
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <talus/vectors/instruction_set.h>
#include <talus/voxel/coords.h>

#include "plane_model.h"
#include "rans.h"

namespace talus::codec {

inline constexpr std::size_t kMaxBytesOfKinds = 5;

/// Number of bytes that a decoder may read past the end. After the kinds of a plane's rows, a row may take
/// one byte for each column's state and one for its change; truncation is only detected afterwards. A vector
/// load reads further.
inline constexpr std::size_t kReadAhead = 128;
static_assert(kReadAhead >= kMaxBytesOfKinds + 2 * kChunkSize + kLanes);

enum class PlaneFault : std::uint8_t { none, truncated, bad_number };

/// Encoded form of a plane; in each row the even columns come before the odd ones.
struct PlaneIntervals {
  std::array<std::uint16_t, kChunkArea> start;   // 0 to kProbabilityTotal
  std::array<std::uint16_t, kChunkArea> size;    // 1 to 255
  std::array<std::uint32_t, kChunkSize> others;  // by row: bit x is set if a change follows for column x
  std::array<std::int8_t, kChunkArea> changes;   // by column, valid in rows with any change
  std::uint32_t carried = 0;                     // bit z is set if row z is carried; never bit 0
};

/// For each column one byte of its state and one of its change.
inline constexpr std::size_t kMaxBytesOfPlane = kMaxBytesOfKinds + 2 * kChunkArea;

/// Decodes the plane above `below`. After a fault, the rows from there on are undefined.
using PlaneDecode = PlaneFault (*)(RansSource& source, const std::uint8_t* below, std::uint8_t* plane);

struct PlaneEncode {
  /// Computes the intervals of a plane's symbols.
  void (*model)(const std::uint8_t* plane, const std::uint8_t* below, PlaneIntervals& intervals);
  /// Writes the intervals. REQUIRES: room for kMaxBytesOfPlane and kScribbled before sink.next.
  void (*encode)(const PlaneIntervals& intervals, RansSink& sink);
};

struct PlaneKernels {
  PlaneDecode decode;
  void (*model)(const std::uint8_t* plane, const std::uint8_t* below, PlaneIntervals& intervals);
  void (*encode)(const PlaneIntervals& intervals, RansSink& sink);
};

[[nodiscard]] PlaneDecode plane_decode(InstructionSet set);
[[nodiscard]] const PlaneEncode& plane_encode(InstructionSet set);
[[nodiscard]] PlaneKernels plane_kernels(InstructionSet set);

/// The kernels of instruction_set().
[[nodiscard]] const PlaneKernels& plane_kernels();

/// Reads which rows of a plane are carried: bit z for row z, never the first, which has its own kind. Any
/// other bit is a fault.
[[nodiscard]] inline std::uint32_t take_carried(RansSource& source, bool& fault) {
  const std::uint32_t present = *source.next++;
  std::uint32_t carried = 0;
  for (std::uint32_t byte = 0; byte < 4; ++byte) {
    if ((present >> byte & 1U) != 0) carried |= std::uint32_t{*source.next++} << (8 * byte);
  }
  fault = present > 15 || (carried & 1U) != 0;
  return carried;
}

/// Inverse of take_carried().
inline void put_carried(RansSink& sink, std::uint32_t carried) {
  std::uint32_t present = 0;
  for (std::uint32_t byte = 4; byte-- > 0;) {
    const std::uint32_t rows = carried >> (8 * byte) & 0xFFU;
    if (rows == 0) continue;
    *--sink.next = static_cast<std::uint8_t>(rows);
    present |= 1U << byte;
  }
  *--sink.next = static_cast<std::uint8_t>(present);
}

/// Writes the changes that follow row z.
inline void put_others(RansSink& sink, const PlaneIntervals& intervals, std::size_t z) {
  for (std::uint32_t others = intervals.others[z]; others != 0;) {
    const auto x = static_cast<std::uint32_t>(std::bit_width(others) - 1);
    *--sink.next = static_cast<std::uint8_t>(intervals.changes[z * kChunkSize + x]);
    others ^= 1U << x;
  }
}

[[nodiscard]] constexpr RowKind kind_of(std::uint32_t carried, std::size_t z) {
  if (z == 0) return kFirst;
  return (carried >> z & 1U) != 0 ? kCarried : kLevel;
}

/// Replaces the steps of symbols kOther, which the symbols alone do not determine. Returns the position after
/// the bytes read.
inline const std::uint8_t* take_others(const std::uint8_t* next, std::uint32_t others, Steps& steps) {
  for (; others != 0; others &= others - 1) {
    steps[static_cast<std::size_t>(std::countr_zero(others))] = static_cast<std::int8_t>(*next++);
  }
  return next;
}

}  // namespace talus::codec
