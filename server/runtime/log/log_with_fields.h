// Structured log lines.
#pragma once

#include <string>
#include <string_view>

#include "runtime/log/logger.h"

namespace talus::server {

/// Logs an info line. If the format is JSON, the JSON object `object` follows the text as the member `name`;
/// text lines omit it.
void log_with_fields(const Logger& log, std::string_view text, const char* name, const std::string& object);

}  // namespace talus::server
