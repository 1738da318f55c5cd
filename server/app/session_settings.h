// From the configuration to what sessions need of it.
#pragma once

#include "config/config.h"
#include "rates/rates.h"
#include "session/session_limits.h"

namespace talus::server {

[[nodiscard]] SessionLimits session_limits(const Limits& limits);
[[nodiscard]] RateLimits rate_limits(const Rates& rates);

}  // namespace talus::server
