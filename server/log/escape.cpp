#include "log/escape.h"

#include <fmt/format.h>

namespace talus::server {

namespace {

std::string escape(std::string_view text, std::string_view also) {
  std::string out;
  for (const char c : text) {
    if (c >= ' ' && c <= '~' && also.find(c) == std::string_view::npos) {
      out += c;
    } else {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
  }
  return out;
}

}  // namespace

std::string escaped(std::string_view text, std::size_t max_bytes) {
  return escape(text.substr(0, max_bytes), "\"\\") + (text.size() > max_bytes ? "..." : "");
}

std::string printable(std::string_view text) {
  return escape(text, "");
}

}  // namespace talus::server
