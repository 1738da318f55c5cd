// Formats a time.
#pragma once

#include <chrono>
#include <string>

namespace talus::server {

/// Formats the time in UTC by strftime(3) with `format`, in English; at most 63 bytes.
[[nodiscard]] std::string utc_time(std::chrono::sys_seconds time, const char* format);

}  // namespace talus::server
