// Checks a View message against the rules of PROTOCOL.md and the limits. Pure functions.
#pragma once

#include <tl/expected.hpp>

#include <talus/protocol/message.h>

#include "player/session/rejection.h"
#include "player/session/session_limits.h"
#include "player/view/area_of_interest.h"

namespace talus::server {

/// Returns the View in a world of these heights, or an error: `malformed` (the connection closes),
/// `too_large`, `out_of_range` or `unsupported`. A View outside the world is valid and has no chunks.
[[nodiscard]] tl::expected<View, Rejection> check_view(const wire::View& view, const SessionLimits& limits,
                                                       HeightRange heights);

}  // namespace talus::server
