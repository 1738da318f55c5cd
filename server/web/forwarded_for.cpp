#include "web/forwarded_for.h"

#include <talus/protocol/header_fields.h>

namespace talus::server::web {
namespace {

/// Some proxies add a port: 192.0.2.1:80, [2001:db8::1]:80.
std::string_view without_port(std::string_view text) {
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    const bool whole = end != std::string_view::npos && (end + 1 == text.size() || text[end + 1] == ':');
    return whole ? text.substr(1, end - 1) : text;
  }
  const std::size_t colon = text.find(':');
  const bool one_colon =
      colon != std::string_view::npos && text.find(':', colon + 1) == std::string_view::npos;
  return one_colon ? text.substr(0, colon) : text;
}

}  // namespace

std::optional<asio::ip::address> forwarded_for(std::string_view list, const Networks& proxies) {
  while (!list.empty()) {
    const std::size_t comma = list.rfind(',');
    const std::size_t begin = comma == std::string_view::npos ? 0 : comma + 1;
    std::error_code failed;
    const auto address =
        asio::ip::make_address(std::string{without_port(protocol::trimmed(list.substr(begin)))}, failed);
    if (failed) return std::nullopt;
    if (!proxies.contain(address)) return address;
    list = list.substr(0, comma == std::string_view::npos ? 0 : comma);
  }
  return std::nullopt;
}

}  // namespace talus::server::web
