#include "runtime/log/program_line.h"

#include <fmt/format.h>

#include "runtime/log/escape.h"
#include "runtime/log/json_lines.h"
#include "runtime/log/spdlog_level.h"

namespace talus::server {

std::string program_line(std::string_view format, LogLevel level, std::string_view text) {
  const std::string safe = on_one_line(text);
  if (format == "json") {
    spdlog::memory_buf_t line;
    JsonLines{}.format({"talusd", spdlog_level(level), safe}, line);
    return {line.data(), line.size()};
  }
  return fmt::format("talusd: {}{}\n", level == LogLevel::warn ? "warning: " : "", safe);
}

}  // namespace talus::server
