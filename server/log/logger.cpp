#include "log/logger.h"

#include <string>

#include <spdlog/sinks/stdout_sinks.h>

namespace talus::server {

Logger make_logger(std::string_view level) {
  auto logger = std::make_shared<spdlog::logger>("talusd", std::make_shared<spdlog::sinks::stdout_sink_mt>());
  logger->set_pattern("%Y-%m-%dT%H:%M:%S.%e%z %l %v");
  logger->set_level(spdlog::level::from_str(std::string{level}));
  logger->flush_on(spdlog::level::info);
  return logger;
}

}  // namespace talus::server
