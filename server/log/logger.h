// The server's log: lines on stdout, made once in main and handed down.
#pragma once

#include <memory>
#include <string_view>

#include <spdlog/logger.h>

namespace talus::server {

using Logger = std::shared_ptr<spdlog::logger>;

/// `level` (trace, debug, info, warning, error, off) and `format` (text, json) are names that the
/// configuration takes.
[[nodiscard]] Logger make_logger(std::string_view level, std::string_view format);
/// The same log, for what clients cause: its info lines are rationed, so that they bury nothing else.
[[nodiscard]] Logger for_clients(const Logger& log);

}  // namespace talus::server
