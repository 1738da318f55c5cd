// Bytes as hexadecimal digits.
#pragma once

#include <string>
#include <string_view>

#include <talus/protocol/message.h>

namespace talus::protocol::testing {

[[nodiscard]] inline std::string hex(const Frame& frame) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const std::byte byte : frame) {
    text += kDigits[std::to_integer<unsigned>(byte) >> 4];
    text += kDigits[std::to_integer<unsigned>(byte) & 15U];
  }
  return text;
}

[[nodiscard]] inline Frame unhex(std::string_view text) {
  Frame frame;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    frame.push_back(static_cast<std::byte>(std::stoi(std::string{text.substr(i, 2)}, nullptr, 16)));
  }
  return frame;
}

}  // namespace talus::protocol::testing
