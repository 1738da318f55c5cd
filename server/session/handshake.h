// What a Hello is answered with. Pure.
#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include <talus/protocol/message.h>

#include "config/config.h"

namespace talus::server {

/// What both sides will speak.
struct Greeting {
  std::uint16_t protocol = 0;
  std::uint8_t codec = 0;
  std::uint64_t window_bytes = 0;
  std::string client;  // as it came: escape before logging
};

/// Why the connection closes.
struct Rejection {
  wire::ErrorCode code{};
  std::string text;
};

[[nodiscard]] tl::expected<Greeting, Rejection> greet(const wire::Hello& hello, const Limits& limits);

}  // namespace talus::server
