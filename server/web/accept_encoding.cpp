#include "web/accept_encoding.h"

#include <algorithm>

namespace talus::server::web {
namespace {

std::string_view without_space(std::string_view text) {
  constexpr std::string_view kSpace{" \t"};
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

bool is_named(std::string_view text, std::string_view lower_case) {
  return std::equal(text.begin(), text.end(), lower_case.begin(), lower_case.end(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

/// "q=0", "q=0.0": the only weights that matter here.
bool is_refusal(std::string_view weight) {
  if (!is_named(weight.substr(0, 2), "q=")) return false;
  weight.remove_prefix(2);
  return !weight.empty() && weight.find_first_not_of("0.") == std::string_view::npos;
}

}  // namespace

bool accepts_encoding(std::string_view list, std::string_view encoding) {
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const std::string_view item = list.substr(0, comma);
    list.remove_prefix(std::min(comma + 1, list.size()));
    const std::size_t semicolon = std::min(item.find(';'), item.size());
    if (!is_named(without_space(item.substr(0, semicolon)), encoding)) continue;
    return semicolon == item.size() || !is_refusal(without_space(item.substr(semicolon + 1)));
  }
  return false;
}

}  // namespace talus::server::web
