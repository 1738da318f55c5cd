#include "config/access/list_file.h"

#include <algorithm>

#include <fmt/format.h>

#include <talus/files/read_file.h>

#include "config/trimmed.h"
#include "runtime/log/escape.h"

namespace talus::server {

tl::expected<void, std::string> parse_list(std::string_view text, const AddLine& add) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.front() == '#') continue;
    if (const std::string wrong = add(line, number); !wrong.empty()) {
      return tl::make_unexpected(fmt::format("line {}: {}", number, wrong));
    }
  }
  return {};
}

tl::expected<void, std::string> read_list(const std::filesystem::path& file, const AddLine& add) {
  const auto wrong = [&](const std::string& what) {
    return tl::make_unexpected(fmt::format("{}: {}", escaped(file.string(), 500), what));
  };
  const auto text = files::read_regular_file(file, kMaxListFileBytes);
  if (!text) return wrong(text.error().reason);
  if (const auto parsed = parse_list(*text, add); !parsed) return wrong(parsed.error());
  return {};
}

std::string_view take_word(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of(" \t\r"), text.size());
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

}  // namespace talus::server
