#include "config/endpoint.h"

#include <charconv>

#include <fmt/format.h>

#include "log/escape.h"

namespace talus::server {
namespace {

constexpr std::size_t kMaxHostBytes = 253;  // of a DNS name

bool valid_host(std::string_view host, bool bracketed) {
  if (host.empty() || host.size() > kMaxHostBytes) return false;
  for (const char c : host) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    const bool sign = c == '.' || c == '-' || c == '_' || (bracketed && (c == ':' || c == '%'));
    if (!letter && !sign) return false;
  }
  return true;
}

tl::unexpected<std::string> wrong(std::string_view text) {
  return tl::make_unexpected(fmt::format(
      "\"{}\" is not HOST:PORT; write for example 127.0.0.1:4780 or [::]:4780, the port 0 to 65535",
      escaped(text)));
}

}  // namespace

tl::expected<Endpoint, std::string> parse_endpoint(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return wrong(text);
  std::string_view host = text.substr(0, colon);
  const std::string_view digits = text.substr(colon + 1);
  const bool bracketed = host.size() >= 2 && host.front() == '[' && host.back() == ']';
  if (bracketed) host = host.substr(1, host.size() - 2);
  if (!valid_host(host, bracketed)) return wrong(text);

  Endpoint endpoint{std::string{host}, 0};
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, endpoint.port);
  if (digits.empty() || error != std::errc{} || stop != end) return wrong(text);
  return endpoint;
}

std::string to_string(const Endpoint& endpoint) {
  const bool v6 = endpoint.host.find(':') != std::string::npos;
  return fmt::format("{}{}{}:{}", v6 ? "[" : "", endpoint.host, v6 ? "]" : "", endpoint.port);
}

}  // namespace talus::server
