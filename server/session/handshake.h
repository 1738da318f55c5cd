// What a Hello is answered with. Pure.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/protocol/message.h>

#include "access/access_control.h"
#include "config/config.h"

namespace talus::server {

/// What both sides will speak.
struct Greeting {
  std::uint16_t protocol = 0;
  std::uint8_t codec = 0;
  std::uint64_t window_bytes = 0;
  std::string client;  // as it came: escape before logging
  Grant grant;
};

/// Why the connection closes.
struct Rejection {
  wire::ErrorCode code{};
  std::string text;
  std::string why{};                          // more, for the log alone
  std::optional<AuthFailure> auth_failure{};  // where the token is the reason
};

/// The token is looked at last, as of `now`.
[[nodiscard]] tl::expected<Greeting, Rejection> greet(const wire::Hello& hello, const Limits& limits,
                                                      const AccessControl& access,
                                                      std::chrono::sys_seconds now);

}  // namespace talus::server
