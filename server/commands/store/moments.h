// Times in commands, as people write and read them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server {

/// "90s", "30m", "2h", "7d": so long before `now_ms`. Or a time in UTC: "2026-11-25", "2026-11-25T08:30:00Z".
/// Milliseconds since 1970. The error says what is expected.
[[nodiscard]] tl::expected<std::int64_t, std::string> parse_moment(std::string_view text,
                                                                   std::int64_t now_ms);

/// "2026-11-25T08:30:00Z".
[[nodiscard]] std::string moment(std::int64_t time_ms);

}  // namespace talus::server
