#include "app/session_settings.h"

#include <chrono>

namespace talus::server {

using std::chrono::milliseconds;

SessionLimits session_limits(const Limits& limits) {
  return {.frame_bytes = static_cast<std::uint32_t>(limits.frame_bytes),
          .requests_in_flight = static_cast<std::uint32_t>(limits.requests_in_flight),
          .heights_per_request = static_cast<std::uint32_t>(limits.heights_per_request),
          .height_tiles_per_request = limits.height_tiles_per_request,
          .view_horizontal_radius = static_cast<std::uint16_t>(limits.view_horizontal_radius),
          .view_vertical_radius = static_cast<std::uint16_t>(limits.view_vertical_radius),
          .view_chunks = static_cast<std::uint32_t>(limits.view_chunks),
          .window_bytes = limits.window_bytes,
          .queued_bytes = limits.queued_bytes_per_session,
          .idle_timeout = milliseconds{static_cast<milliseconds::rep>(limits.idle_timeout_ms)}};
}

RateLimits rate_limits(const Rates& rates) {
  const milliseconds pause{static_cast<milliseconds::rep>(rates.burst_ms)};
  const auto rate = [&](std::uint64_t per_second) { return Rate::with_burst_of(per_second, pause); };
  return {{rate(rates.session_chunks), rate(rates.session_bytes), rate(rates.session_requests)},
          {rate(rates.address_chunks), rate(rates.address_bytes), rate(rates.address_requests)}};
}

}  // namespace talus::server
