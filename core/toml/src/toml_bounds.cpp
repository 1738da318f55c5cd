#include <talus/toml/toml_bounds.h>

#include <algorithm>

namespace talus {
namespace {

/// Returns true if a text may begin with this byte, also of a byte order mark. Pictures begin with others.
bool begins_text(char first) {
  constexpr char kDelete = 0x7F;
  constexpr char kByteOrderMark = '\xEF';
  return (first >= ' ' && first != kDelete) || first == '\t' || first == '\n' || first == '\r' ||
         first == kByteOrderMark;
}

}  // namespace

std::optional<TomlFault> find_toml_fault(std::string_view text) {
  if (text.size() > kMaxTomlBytes) {
    return TomlFault{1, "the file has over " + std::to_string(kMaxTomlBytes) + " bytes"};
  }
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return TomlFault{1, "the file is in UTF-16; TOML is in UTF-8, so save it as that"};
  }
  if (!text.empty() && !begins_text(text.front())) return TomlFault{1, "the file is not text"};
  // Counts outside strings and comments. Numbers have dots too, but never that many in a line. A parser stops
  // at the first line end inside a single-line string, so the text after it does not matter.
  int line = 1;
  std::size_t dots = 0;   // in the line
  std::size_t depth = 0;  // of brackets and braces
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      ++line;
      dots = 0;
      quote = 0;
    } else if (quote != 0) {
      const bool escapes = c == '\\' && quote == '"' && i + 1 < text.size() && text[i + 1] != '\n';
      if (escapes) ++i;
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      if (text.substr(i, 3) == std::string(3, c)) {
        return TomlFault{line, "a string in three quotes; only strings of one line are read, in one quote"};
      }
      quote = c;
    } else if (c == '#') {
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (c == '[' || c == '{') {
      if (++depth > kMaxTomlDepth) {
        return TomlFault{line, "more than " + std::to_string(kMaxTomlDepth) + " brackets within each other"};
      }
    } else if (c == ']' || c == '}') {
      if (depth > 0) --depth;
    } else if (c == '.' && ++dots >= kMaxKeyParts) {
      return TomlFault{line, "a key of more than " + std::to_string(kMaxKeyParts) + " parts"};
    }
  }
  return std::nullopt;
}

}  // namespace talus
