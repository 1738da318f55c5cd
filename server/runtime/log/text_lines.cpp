#include "runtime/log/text_lines.h"

#include <string>
#include <string_view>

#include "runtime/log/escape.h"

namespace talus::server {

void TextLines::format(const spdlog::details::log_msg& line, spdlog::memory_buf_t& out) {
  const std::string text = on_one_line({line.payload.data(), line.payload.size()});
  spdlog::details::log_msg escaped = line;
  escaped.payload = text;
  plain_.format(escaped, out);
}

std::unique_ptr<spdlog::formatter> TextLines::clone() const {
  return std::make_unique<TextLines>();
}

}  // namespace talus::server
