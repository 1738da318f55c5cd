// The limits of sessions under test.
#pragma once

#include <chrono>
#include <cstdint>

#include "player/session/session_limits.h"

namespace talus::server {

[[nodiscard]] inline SessionLimits test_limits(std::uint64_t window_bytes = 4U << 20) {
  return {.frame_bytes = 65'536,
          .requests_in_flight = 1024,
          .heights_per_request = 2048,
          .height_tiles_per_request = 2048,
          .view_horizontal_radius = 48,
          .view_vertical_radius = 16,
          .view_chunks = 65'536,
          .window_bytes = window_bytes,
          .queued_bytes = 1U << 20,
          .idle_timeout = std::chrono::minutes{1}};
}

}  // namespace talus::server
