// Checks GetHeights messages. Pure functions.
#pragma once

#include <cstddef>

#include <tl/expected.hpp>

#include <talus/protocol/message.h>

#include "chunks/heights_query.h"
#include "player/session/rejection.h"
#include "player/session/session_limits.h"

namespace talus::server {

/// Returns the query or an error: `too_large` or `out_of_range`. `world_fields`: number of the world's
/// fields.
[[nodiscard]] tl::expected<HeightsQuery, Rejection> check_heights(const wire::GetHeights& get,
                                                                  const SessionLimits& limits,
                                                                  std::size_t world_fields);
/// Makes the same checks for a query of another origin, except for its number of columns.
[[nodiscard]] tl::expected<void, Rejection> check_query(const HeightsQuery& query,
                                                        const SessionLimits& limits,
                                                        std::size_t world_fields);

}  // namespace talus::server
