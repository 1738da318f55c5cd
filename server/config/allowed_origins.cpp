#include "config/allowed_origins.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

#include <fmt/format.h>
#include <asio/ip/address.hpp>

#include <talus/protocol/header_fields.h>

namespace talus::server {
namespace {

/// A host and a port as browsers spell them: in lower case, without a default port.
struct Place {
  std::string host;
  std::string port;  // ":8080"; empty: the scheme's
  bool operator==(const Place&) const = default;
};

/// Removes "http" or "https" from an origin and returns it; nullopt for other texts.
std::optional<std::string_view> take_scheme(std::string_view& origin) {
  for (const std::string_view scheme : {"https", "http"}) {
    if (!protocol::same_name(origin.substr(0, scheme.size()), scheme)) continue;
    if (origin.substr(scheme.size(), 3) != "://") continue;
    origin.remove_prefix(scheme.size() + 3);
    return scheme;
  }
  return std::nullopt;
}

/// Parses "HOST" or "HOST:PORT".
std::optional<Place> place_of(std::string_view text, std::string_view scheme) {
  const std::size_t bracket = text.starts_with('[') ? text.find(']') : 0;
  if (bracket == std::string_view::npos) return std::nullopt;
  const std::size_t colon = std::min(text.find(':', bracket), text.size());
  std::string_view host = text.substr(0, colon);
  if (host.ends_with('.')) host.remove_suffix(1);
  Place place;
  for (const char c : host) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool plain =
        upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_';
    if (!plain && (bracket == 0 || (c != '[' && c != ']' && c != ':'))) return std::nullopt;
    place.host += upper ? static_cast<char>(c + ('a' - 'A')) : c;
  }
  if (place.host.empty()) return std::nullopt;
  const std::string_view port = text.substr(std::min(colon + 1, text.size()));
  std::uint16_t number = 0;
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), number);
  if (!port.empty() && (error != std::errc{} || end != port.data() + port.size())) return std::nullopt;
  if (!port.empty() && number != (scheme == "https" ? 443 : 80)) place.port = fmt::format(":{}", number);
  return place;
}

/// Returns the origin as browsers spell it; nullopt if it is not a scheme, host and optional port.
std::optional<std::string> spelled(std::string_view origin) {
  const auto scheme = take_scheme(origin);
  const auto place = scheme ? place_of(origin, *scheme) : std::nullopt;
  return place ? std::optional{fmt::format("{}://{}{}", *scheme, place->host, place->port)} : std::nullopt;
}

}  // namespace

tl::expected<AllowedOrigins, std::string> AllowedOrigins::parse(std::string_view text) {
  AllowedOrigins allowed;
  allowed.text_ = text;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    std::string_view each = text.substr(0, comma);
    while (each.starts_with(' ')) each.remove_prefix(1);
    while (each.ends_with(' ')) each.remove_suffix(1);
    if (each == "*") {
      allowed.all_ = true;
    } else if (auto origin = spelled(each)) {
      allowed.origins_.push_back(*std::move(origin));
    } else {
      return tl::make_unexpected(
          fmt::format("'{}' is not an origin; write https://play.example, or * for all", each.substr(0, 80)));
    }
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
  return allowed;
}

bool AllowedOrigins::allow(std::string_view origin, std::string_view host) const {
  if (all_) return true;
  std::string_view rest = origin;
  const auto scheme = take_scheme(rest);
  const auto place = scheme ? place_of(rest, *scheme) : std::nullopt;
  if (!place) return false;
  if (place == place_of(host, *scheme)) return true;
  if (loopback_ && is_loopback(place->host)) return true;
  return lists(fmt::format("{}://{}{}", *scheme, place->host, place->port));
}

bool AllowedOrigins::lists(std::string_view origin) const {
  return std::find(origins_.begin(), origins_.end(), origin) != origins_.end();
}

bool is_loopback(std::string_view host) {
  if (host == "localhost" || host.ends_with(".localhost")) return true;
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  std::error_code failed;
  const auto address = asio::ip::make_address(std::string{host}, failed);
  return !failed && address.is_loopback();
}

}  // namespace talus::server
