#include "web/accept_encoding.h"

#include <algorithm>

#include <talus/protocol/header_fields.h>

namespace talus::server::web {
namespace {

/// "q=0", "q=0.0": all other weights mean acceptance.
bool is_refusal(std::string_view weight) {
  if (!protocol::same_name(weight.substr(0, 2), "q=")) return false;
  weight.remove_prefix(2);
  return !weight.empty() && weight.find_first_not_of("0.") == std::string_view::npos;
}

}  // namespace

bool accepts_encoding(std::string_view list, std::string_view encoding) {
  while (!list.empty()) {
    const std::string_view item = protocol::take_item(list);
    const std::size_t semicolon = std::min(item.find(';'), item.size());
    if (!protocol::same_name(protocol::trimmed(item.substr(0, semicolon)), encoding)) continue;
    return semicolon == item.size() || !is_refusal(protocol::trimmed(item.substr(semicolon + 1)));
  }
  return false;
}

}  // namespace talus::server::web
