#include "fields.h"

#include <algorithm>

#include <talus/protocol/header_fields.h>

namespace talus::websocket {
std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 2, text.size()));
  return line;
}

std::string printable(std::string_view text) {
  constexpr std::size_t kMaxLength = 100;
  std::string line{text.substr(0, kMaxLength)};
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return line;
}

std::optional<std::string> Fields::list(std::string_view name) const {
  std::optional<std::string> values;
  for (std::string_view rest = text_; !rest.empty();) {
    const std::string_view line = next_line(rest);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || !protocol::same_name(line.substr(0, colon), name)) continue;
    values = values ? *values + ", " : std::string{};
    values->append(protocol::trimmed(line.substr(colon + 1)));
  }
  return values;
}

}  // namespace talus::websocket
