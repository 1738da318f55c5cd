// The server's log on stdout. main makes it once and passes it down.
#pragma once

#include <memory>
#include <string_view>

#include <spdlog/logger.h>

namespace talus::server {

using Logger = std::shared_ptr<spdlog::logger>;

/// `level` is trace, debug, info, warning, error or off; `format` is text or json. The configuration checks
/// both.
[[nodiscard]] Logger make_logger(std::string_view level, std::string_view format);
/// The same log for lines that clients cause: the number of its info lines per second is limited.
[[nodiscard]] Logger for_clients(const Logger& log);

}  // namespace talus::server
