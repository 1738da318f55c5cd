#include "commands/store/subjects.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

constexpr std::string_view kNoToken = "(no token)";

/// Characters that look like a space, are invisible, or reverse the text direction: they could make two
/// subjects look alike, or hide where a subject ends. Both bounds are inclusive.
constexpr std::array<std::pair<char32_t, char32_t>, 14> kUnseen{{{0xA0, 0xA0},
                                                                 {0xAD, 0xAD},
                                                                 {0x34F, 0x34F},
                                                                 {0x61C, 0x61C},
                                                                 {0x115F, 0x1160},
                                                                 {0x1680, 0x1680},
                                                                 {0x17B4, 0x17B5},
                                                                 {0x180B, 0x180F},
                                                                 {0x2000, 0x200F},
                                                                 {0x2028, 0x202F},
                                                                 {0x205F, 0x206F},
                                                                 {0x3000, 0x3000},
                                                                 {0xFE00, 0xFE0F},
                                                                 {0xFEFF, 0xFEFF}}};

/// Decodes the UTF-8 character at the beginning of the text.
char32_t code_point(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  if (first < 0x80) return first;
  char32_t code = first & (0x7FU >> character.size());
  for (const char next : character.substr(1)) code = code << 6U | (static_cast<unsigned char>(next) & 0x3FU);
  return code;
}

bool is_visible(std::string_view character) {
  const char32_t code = code_point(character);
  if (code >= 0xE0000 || (code >= 0xFFF0 && code <= 0xFFFB)) return false;  // tags, private use, interlinear
  return std::ranges::none_of(kUnseen,
                              [&](const auto& range) { return code >= range.first && code <= range.second; });
}

}  // namespace

std::string subject_text(std::string_view subject) {
  if (subject.empty()) return std::string{kNoToken};
  std::string text;
  const bool looks_like_none = subject == kNoToken;
  while (!subject.empty()) {
    const std::size_t bytes = printable_bytes(subject);
    const std::string_view character = subject.substr(0, std::max<std::size_t>(1, bytes));
    subject.remove_prefix(character.size());
    const bool is_end = text.empty() || subject.empty();
    const bool plain = character == " "   ? !is_end && !text.ends_with(' ')
                       : character == "(" ? !is_end || !looks_like_none
                                          : bytes > 0 && character != "\\" && is_visible(character);
    if (plain) {
      text += character;
    } else {
      for (const char byte : character) text += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
    }
  }
  return text;
}

tl::expected<std::string, std::string> parse_subject(std::string_view text) {
  if (text == kNoToken) return std::string{};
  std::string subject;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] != '\\') {
      subject += text[at++];
      continue;
    }
    std::uint8_t byte = 0;
    const std::string_view digits = text.substr(std::min(at + 2, text.size())).substr(0, 2);
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    if (!text.substr(at).starts_with("\\x") || digits.size() != 2 || error != std::errc{} ||
        stop != digits.data() + 2) {
      return tl::unexpected{
          fmt::format("\"{}\" has a backslash that begins no byte as \\xNN; write a backslash as \\x5c",
                      on_one_line(text))};
    }
    subject += static_cast<char>(byte);
    at += 4;
  }
  return subject;
}

}  // namespace talus::server
