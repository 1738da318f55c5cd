// Startup errors of talusd on stderr, reported before or without a log.
#pragma once

#include <string>
#include <string_view>

#include "runtime/log/logger.h"

namespace talus::server {

/// One line with its newline: "talusd: TEXT", "talusd: warning: TEXT", or a JSON log object if `format` is
/// json. Bytes of `text` that are not printable ASCII become \xNN.
[[nodiscard]] std::string program_line(std::string_view format, LogLevel level, std::string_view text);

}  // namespace talus::server
