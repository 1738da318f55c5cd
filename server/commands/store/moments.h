// Times in commands, in readable form.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server {

/// Parses "90s", "30m", "2h" or "7d" as that time before `now_ms`, or a UTC time such as "2026-11-25" or
/// "2026-11-25T08:30:00Z". Returns milliseconds since 1970. The error states what is expected.
[[nodiscard]] tl::expected<std::int64_t, std::string> parse_moment(std::string_view text,
                                                                   std::int64_t now_ms);

/// Formats as "2026-11-25T08:30:00Z".
[[nodiscard]] std::string moment(std::int64_t time_ms);

}  // namespace talus::server
