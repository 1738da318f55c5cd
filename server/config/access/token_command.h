// `talusd token`: makes a signed token.
#pragma once

#include <chrono>
#include <string>

#include <tl/expected.hpp>

#include "config/parse_flags.h"

namespace talus::server {

/// The token that the flags describe; `argv[0]` is "token". Else what to print, and the exit status.
[[nodiscard]] tl::expected<std::string, Exit> token_command(int argc, const char* const* argv,
                                                            std::chrono::sys_seconds now);

/// "90s", "30m", "12h" or "7d", from one second to ten years. The error says what is expected.
[[nodiscard]] tl::expected<std::chrono::seconds, std::string> parse_validity(std::string_view text);

}  // namespace talus::server
