// Planes column by column: where the compiler makes no vectors of sixteen bytes, and to hold the others
// against.
#pragma once

#include "plane_kernels.h"

namespace talus::codec {

[[nodiscard]] PlaneFault read_plane_plainly(PlaneSource& source, const std::uint8_t* below,
                                            std::uint8_t* plane);
void weigh_plane_plainly(const std::uint8_t* plane, const std::uint8_t* below, PlaneShares& shares);
void write_plane_plainly(const PlaneShares& shares, PlaneSink& sink);

}  // namespace talus::codec
