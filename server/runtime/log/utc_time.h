// A time as text.
#pragma once

#include <chrono>
#include <string>

namespace talus::server {

/// The time in UTC, as strftime(3) writes it by `format`, in English; at most 63 bytes.
[[nodiscard]] std::string utc_time(std::chrono::sys_seconds time, const char* format);

}  // namespace talus::server
