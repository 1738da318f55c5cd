// Lines of the log that programs read, not only people.
#pragma once

#include <string>
#include <string_view>

#include "runtime/log/logger.h"

namespace talus::server {

/// An info line that also has fields: where lines are JSON, `object`, a JSON object, is the member `name`
/// after the text. Text lines have the text alone.
void log_with_fields(const Logger& log, std::string_view text, const char* name, const std::string& object);

}  // namespace talus::server
