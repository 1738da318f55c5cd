#include "printable_line.h"

#include <cstdint>

namespace talus::client {
namespace {

/// Length in bytes of the text's first character; 0 if it does not begin with a valid one (RFC 3629).
std::size_t character_bytes(std::string_view text) {
  const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(text[at]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  const std::size_t bytes = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (text.size() < bytes) return 0;
  for (std::size_t at = 1; at < bytes; ++at) {
    if ((byte(at) & 0xC0U) != 0x80) return 0;
  }
  const std::uint8_t second = byte(1);
  // Overlong, a surrogate, or above U+10FFFF.
  const bool is_none = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
                       (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
  return is_none ? 0 : bytes;
}

}  // namespace

std::string printable_line(std::string_view text, std::size_t max_bytes) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD
  std::string line;
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    std::string_view character = bytes == 0 ? kReplacement : text.substr(0, bytes);
    const auto first = static_cast<std::uint8_t>(character.front());
    if (first < 0x20 || first == 0x7F) character = " ";
    if (line.size() + character.size() > max_bytes) break;
    line += character;
    text.remove_prefix(bytes == 0 ? 1 : bytes);
  }
  return line;
}

}  // namespace talus::client
