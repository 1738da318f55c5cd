#include "runtime/log/log_with_fields.h"

namespace talus::server {

// spdlog passes a line's source location to its formatter, on the logging thread. Only these lines have one.
void log_with_fields(const Logger& log, std::string_view text, const char* name, const std::string& object) {
  log->log(spdlog::source_loc{name, 1, object.c_str()}, spdlog::level::info, "{}", text);
}

}  // namespace talus::server
