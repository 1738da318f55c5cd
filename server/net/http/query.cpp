#include "net/http/query.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

namespace talus::server::http {

std::vector<std::string_view> split(std::string_view text, char by, std::size_t max_parts) {
  std::vector<std::string_view> parts;
  while (parts.size() + 1 < max_parts) {
    const std::size_t at = text.find(by);
    if (at == std::string_view::npos) break;
    parts.push_back(text.substr(0, at));
    text.remove_prefix(at + 1);
  }
  parts.push_back(text);
  return parts;
}

namespace {

/// Puts `plus` in place of each plus sign.
std::optional<std::string> decoded_with(std::string_view text, char plus) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '%') {
      decoded += text[at] == '+' ? plus : text[at];
      continue;
    }
    unsigned char byte = 0;
    const char* const digits = text.data() + at + 1;
    if (text.size() - at < 3 || std::from_chars(digits, digits + 2, byte, 16).ptr != digits + 2) {
      return std::nullopt;
    }
    decoded += static_cast<char>(byte);
    at += 2;
  }
  return decoded;
}

}  // namespace

std::optional<std::string> percent_decoded(std::string_view text) {
  return decoded_with(text, '+');
}

std::optional<std::string> form_decoded(std::string_view text) {
  return decoded_with(text, ' ');
}

tl::expected<Query, std::string> Query::parse(std::string_view text) {
  constexpr std::size_t kMaxPairs = 32;
  Query query;
  for (const std::string_view part : split(text, '&', kMaxPairs)) {
    if (part.empty()) continue;
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string_view raw = part.substr(std::min(equals + 1, part.size()));
    auto key = form_decoded(part.substr(0, equals));
    auto value = form_decoded(raw);
    if (!key || !value) {
      return tl::make_unexpected(fmt::format(
          "'{}': two hexadecimal digits follow a %, and %25 is a percent sign", part.substr(0, 40)));
    }
    query.pairs_.push_back({*std::move(key), *std::move(value), raw});
  }
  return query;
}

std::optional<Query::Pair> Query::take(std::string_view key) {
  const auto found =
      std::find_if(pairs_.begin(), pairs_.end(), [&](const Pair& pair) { return pair.key == key; });
  if (found == pairs_.end()) return std::nullopt;
  std::optional<Pair> pair{std::move(*found)};
  pairs_.erase(found);
  return pair;
}

}  // namespace talus::server::http
