// Checks what a GetHeights message asks for. Pure.
#pragma once

#include <cstddef>

#include <tl/expected.hpp>

#include <talus/protocol/message.h>

#include "chunks/heights_query.h"
#include "player/session/rejection.h"
#include "player/session/session_limits.h"

namespace talus::server {

/// The query, or what is wrong: `too_large` or `out_of_range`. The world has so many fields.
[[nodiscard]] tl::expected<HeightsQuery, Rejection> check_heights(const wire::GetHeights& get,
                                                                  const SessionLimits& limits,
                                                                  std::size_t world_fields);
/// The same of a query that came otherwise, but for its number of columns.
[[nodiscard]] tl::expected<void, Rejection> check_query(const HeightsQuery& query,
                                                        const SessionLimits& limits,
                                                        std::size_t world_fields);

}  // namespace talus::server
