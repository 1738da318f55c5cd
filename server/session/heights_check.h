// Checks the columns of a GetHeights message. Pure.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include <talus/protocol/message.h>
#include <talus/terrain/heights.h>

#include "session/rejection.h"
#include "session/session_limits.h"

namespace talus::server {

/// The columns in their order, or what is wrong: `too_large` or `out_of_range`.
[[nodiscard]] tl::expected<std::vector<terrain::BaseColumn>, Rejection> check_heights(
    const wire::GetHeights& get, const SessionLimits& limits);

}  // namespace talus::server
