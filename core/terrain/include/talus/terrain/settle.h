// Loose material at rest (thesis 3.6, eq. 3 and figures 13-14).
#pragma once

#include <cstdint>

#include <talus/terrain/field.h>

namespace talus::terrain {

/// Thickness before settling, eq. 3: 0 where the slope exceeds `max_slope_fx`, else thickness_fx on level
/// ground, falling to 0 at max_slope_fx, rounded down. REQUIRES 0 <= thickness_fx <= 2^20, 1 <= max_slope_fx.
[[nodiscard]] Field starting_thickness(const Field& slope, std::int32_t thickness_fx,
                                       std::int32_t max_slope_fx);

/// Removes material until no column exceeds any of its eight neighbours by more than `repose_fx`.
///
/// The result is unique: the largest field under the start whose neighbours differ by at most c,
/// g*(i) = min over j of g(j) + c d(i, j) with d the chessboard distance. That is a distance transform, and
/// min and + commute with the two raster passes of Rosenfeld and Pfaltz (1966), so two passes give it
/// exactly: forward from W, NW, N, NE, backward from E, SE, S, SW.
///
/// Halo: thickness never exceeds t, so a source at distance d >= ceil(t/c) lowers nothing. With a ring of
/// ceil(t/c) - 1 columns around it, a region is exactly the endless plane's.
/// REQUIRES 0 <= values <= 2^20, 1 <= repose_fx.
void settle(Field& thickness, std::int32_t repose_fx);

}  // namespace talus::terrain
