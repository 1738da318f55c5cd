// Scalar coding of planes, as in FORMAT.md: the reference for the kernels of every instruction set.
#pragma once

#include "plane_kernels.h"

namespace talus::codec {

[[nodiscard]] PlaneFault decode_plane_scalar(RansSource& source, const std::uint8_t* below,
                                             std::uint8_t* plane);
void model_plane_scalar(const std::uint8_t* plane, const std::uint8_t* below, PlaneIntervals& intervals);
void encode_plane_scalar(const PlaneIntervals& intervals, RansSink& sink);

/// Symbols of a row's columns, as far as they are known.
using Symbols = std::array<Symbol, kChunkSize>;

/// Starts of the intervals of column x's four symbols, and the end of the last. For an odd column the
/// neighbours' symbols must be known.
using Starts = std::array<int, 5>;
[[nodiscard]] Starts starts_of(const RowsBefore& before, RowKind kind, const Symbols& symbols, std::size_t x);

}  // namespace talus::codec
