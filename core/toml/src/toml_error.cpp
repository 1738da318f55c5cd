#include <talus/toml/toml_error.h>

#include <algorithm>
#include <map>
#include <optional>

namespace talus {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::size_t kMaxDescription = 300;  // bytes

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return trimmed(line);
}

/// The table that a line opens; nullopt if it opens none, such as a line of an array. `counts` holds the
/// number of [[tables]] so far by name.
std::optional<std::string> header(std::string_view line, std::map<std::string, int, std::less<>>& counts) {
  if (!line.starts_with('[')) return std::nullopt;
  const bool of_array = line.starts_with("[[");
  line.remove_prefix(of_array ? 2 : 1);
  const std::string name{trimmed(line.substr(0, line.find(']')))};
  if (name.empty() || name.find_first_of("[,{\"'") != std::string::npos) return std::nullopt;
  if (!of_array) return name;
  return name + '[' + std::to_string(counts[name]++) + ']';
}

void remove(std::string& text, std::string_view begin, std::string_view end) {
  const std::size_t from = text.find(begin);
  if (from == std::string::npos) return;
  const std::size_t to = text.find(end, from + begin.size());
  if (to != std::string::npos) text.erase(from, to + end.size() - from);
}

}  // namespace

std::string shortened(std::string_view text, std::size_t max_bytes) {
  if (text.size() <= max_bytes) return std::string{text};
  constexpr std::string_view kMore = "...";
  std::size_t end = max_bytes - std::min(max_bytes, kMore.size());
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return std::string{text.substr(0, end)} += kMore;
}

std::string toml_key_at_line(std::string_view toml, int line) {
  std::map<std::string, int, std::less<>> counts;
  std::string table;
  for (int at = 1; at < line && !toml.empty(); ++at) {
    if (const auto opened = header(take_line(toml), counts)) table = *opened + '.';
  }
  const std::string_view text = take_line(toml);
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || text.starts_with('#') || text.starts_with('[')) return {};
  const std::string_view key = trimmed(text.substr(0, equals));
  return key.empty() ? std::string{} : table + std::string{key};
}

std::string toml_error_text(std::string_view description, std::string_view key) {
  constexpr std::string_view kPreamble = "Error while parsing ";
  std::string text = shortened(description, kMaxDescription);
  if (text.starts_with(kPreamble)) {
    // Without a key, keep the name of the parsed construct.
    const std::size_t colon = text.find(": ");
    text.erase(0, key.empty() || colon == std::string::npos ? kPreamble.size() : colon + 2);
  }
  remove(text, " (TOML_", ")");
  constexpr std::string_view kNoValue = "could not determine value type";
  if (const std::size_t at = text.find(kNoValue); at != std::string::npos) {
    text.replace(at, kNoValue.size(), "this is not a value: a string needs quotes");
  }
  return text;
}

}  // namespace talus
