// The level of a line as spdlog has it.
#pragma once

#include <spdlog/common.h>

#include "runtime/log/logger.h"

namespace talus::server {

[[nodiscard]] constexpr spdlog::level::level_enum spdlog_level(LogLevel level) {
  switch (level) {
    case LogLevel::debug:
      return spdlog::level::debug;
    case LogLevel::info:
      return spdlog::level::info;
    case LogLevel::warn:
      return spdlog::level::warn;
    case LogLevel::error:
      break;
  }
  return spdlog::level::err;
}

}  // namespace talus::server
