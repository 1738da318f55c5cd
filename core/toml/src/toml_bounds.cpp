#include <talus/toml/toml_bounds.h>

#include <algorithm>

namespace talus {

std::optional<TomlFault> passes_toml_bounds(std::string_view text) {
  if (text.size() > kMaxTomlBytes) {
    return TomlFault{1, "the file is longer than " + std::to_string(kMaxTomlBytes) + " bytes"};
  }
  // Dots of one line outside of strings and comments. Lists of numbers have some too, but no list here is
  // that long.
  int line = 1;
  std::size_t dots = 0;
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
      quote = c;
    } else if (c == '#') {
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (c == '.' && ++dots >= kMaxKeyParts) {
      return TomlFault{line, "a key of more than " + std::to_string(kMaxKeyParts) + " parts"};
    }
  }
  return std::nullopt;
}

}  // namespace talus
