#include <talus/protocol/endpoint.h>

#include <charconv>

namespace talus::protocol {
namespace {

constexpr std::size_t kMaxHostBytes = 253;  // of a DNS name

bool valid_host(std::string_view host, bool bracketed) {
  if (host.size() > kMaxHostBytes) return false;
  for (const char c : host) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    const bool sign = c == '.' || c == '-' || c == '_' || (bracketed && (c == ':' || c == '%'));
    if (!letter && !sign) return false;
  }
  return true;
}

tl::unexpected<std::string> wrong(std::string_view what) {
  return tl::unexpected{std::string{what} + "; write HOST:PORT, as in localhost:4780 or [::1]:4780"};
}

}  // namespace

tl::expected<Endpoint, std::string> parse_endpoint(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return wrong("the port is missing");
  std::string_view host = text.substr(0, colon);
  const std::string_view digits = text.substr(colon + 1);
  const bool bracketed = host.size() >= 2 && host.front() == '[' && host.back() == ']';
  if (bracketed) host = host.substr(1, host.size() - 2);
  if (host.empty()) return wrong("the host is missing");
  if (!bracketed && host.find(':') != std::string_view::npos) {
    return wrong("an IPv6 address needs brackets, and a port after them");
  }
  if (!valid_host(host, bracketed)) return wrong("the host is neither a name nor an address");

  Endpoint endpoint{std::string{host}, 0};
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, endpoint.port);
  if (digits.empty() || error != std::errc{} || stop != end) {
    return wrong("the port is not a number of at most 65535");
  }
  return endpoint;
}

std::string to_string(const Endpoint& endpoint) {
  const bool v6 = endpoint.host.find(':') != std::string::npos;
  return (v6 ? "[" + endpoint.host + "]" : endpoint.host) + ":" + std::to_string(endpoint.port);
}

}  // namespace talus::protocol
