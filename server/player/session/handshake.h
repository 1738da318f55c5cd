// Checks a Hello. Pure functions.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include <talus/protocol/message.h>

#include "config/access/access_control.h"
#include "player/session/rejection.h"
#include "player/session/session_limits.h"

namespace talus::server {

/// The parameters agreed between client and server.
struct Greeting {
  std::uint16_t protocol = 0;
  std::uint8_t codec = 0;
  std::uint64_t window_bytes = 0;
  std::string client;  // as the client sent it: escape it before logging
  Grant grant;
};

/// Checks versions, codec, length of texts, and finally the token, which must be valid at `now`.
[[nodiscard]] tl::expected<Greeting, Rejection> greet(const wire::Hello& hello, const SessionLimits& limits,
                                                      const AccessControl& access,
                                                      std::chrono::sys_seconds now);

}  // namespace talus::server
