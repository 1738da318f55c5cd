// `talusd token`: makes a signed token.
#pragma once

#include <chrono>
#include <string>

#include <tl/expected.hpp>

#include "config/parse_flags.h"

namespace talus::server {

/// Returns the token that the flags describe, or text to print with the exit status. `argv[0]` is "token".
[[nodiscard]] tl::expected<std::string, Exit> token_command(int argc, const char* const* argv,
                                                            std::chrono::sys_seconds now);

/// Parses "90s", "30m", "12h" or "7d", from one second to ten years. The error states what is expected.
[[nodiscard]] tl::expected<std::chrono::seconds, std::string> parse_validity(std::string_view text);

}  // namespace talus::server
