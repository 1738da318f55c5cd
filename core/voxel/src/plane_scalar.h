// Planes column by column, as FORMAT.md has them: what the kernels of every instruction set must equal.
#pragma once

#include "plane_kernels.h"

namespace talus::codec {

[[nodiscard]] PlaneFault decode_plane_scalar(RansSource& source, const std::uint8_t* below,
                                             std::uint8_t* plane);
void model_plane_scalar(const std::uint8_t* plane, const std::uint8_t* below, PlaneIntervals& intervals);
void encode_plane_scalar(const PlaneIntervals& intervals, RansSink& sink);

}  // namespace talus::codec
