// The server's log: lines on stdout, made once in main and handed down.
#pragma once

#include <memory>
#include <string_view>

#include <spdlog/logger.h>

namespace talus::server {

using Logger = std::shared_ptr<spdlog::logger>;

/// `level` is one of the names that the configuration takes (trace, debug, info, warning, error, off).
[[nodiscard]] Logger make_logger(std::string_view level);

}  // namespace talus::server
