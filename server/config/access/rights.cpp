#include "config/access/rights.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "config/trimmed.h"
#include "runtime/log/escape.h"

namespace talus::server {
namespace {

constexpr std::array kWords{std::pair{Right::read, std::string_view{"read"}},
                            std::pair{Right::edit, std::string_view{"edit"}},
                            std::pair{Right::admin, std::string_view{"admin"}},
                            std::pair{Right::gateway, std::string_view{"gateway"}}};

const Right* find(std::string_view word) {
  for (const auto& [right, name] : kWords) {
    if (name == word) return &right;
  }
  return nullptr;
}

}  // namespace

tl::expected<Rights, std::string> Rights::parse(std::string_view text) {
  Rights rights;
  if (text == "none") return rights;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    const Right* right = find(trimmed(rest.substr(0, comma)));
    if (right == nullptr) break;
    rights.bits_ |= bit(*right);
    if (comma != std::string_view::npos) {
      rest.remove_prefix(comma + 1);
      continue;
    }
    if (!rights.has(Right::read)) break;
    return rights;
  }
  return tl::make_unexpected(
      fmt::format("\"{}\" is wrong; give \"read\", \"read,edit\", or that with \",admin\" or \",gateway\"",
                  escaped(text)));
}

std::string to_string(Rights rights) {
  std::string text;
  for (const auto& [right, word] : kWords) {
    if (!rights.has(right)) continue;
    if (!text.empty()) text += ',';
    text += word;
  }
  return text.empty() ? "none" : text;
}

}  // namespace talus::server
