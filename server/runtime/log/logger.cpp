#include "runtime/log/logger.h"

#include <unistd.h>

#include <memory>
#include <string>

#include "runtime/log/json_lines.h"
#include "runtime/log/non_blocking_sink.h"
#include "runtime/log/text_lines.h"

namespace talus::server {

Logger make_logger(std::string_view level, std::string_view format) {
  auto logger = std::make_shared<spdlog::logger>("talusd", std::make_shared<NonBlockingSink>(STDOUT_FILENO));
  if (format == "json") {
    logger->set_formatter(std::make_unique<JsonLines>());
  } else {
    logger->set_formatter(std::make_unique<TextLines>());
  }
  logger->set_level(spdlog::level::from_str(std::string{level}));
  return logger;
}

Logger for_clients(const Logger& log) {
  return log->clone(std::string{NonBlockingSink::kClientLogger});
}

}  // namespace talus::server
