#include "endpoint.h"

#include <charconv>

namespace talus::cli {

tl::expected<Endpoint, std::string> parse_endpoint(std::string_view text, std::string_view option) {
  const auto wrong = [&](const std::string& why) {
    return tl::unexpected{std::string{option} + " " + std::string{text} + ": " + why +
                          "; write HOST:PORT, as in localhost:4780"};
  };
  const auto colon = text.rfind(':');
  if (colon == std::string_view::npos) return wrong("the port is missing");
  std::string_view host = text.substr(0, colon);
  const std::string_view port = text.substr(colon + 1);
  if (host.size() >= 2 && host.front() == '[' && host.back() == ']') {
    host = host.substr(1, host.size() - 2);
  } else if (host.find(':') != std::string_view::npos) {
    return wrong("an IPv6 address stands in brackets");
  }
  if (host.empty()) return wrong("the host is missing");
  unsigned number = 0;
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), number);
  if (error != std::errc{} || end != port.data() + port.size() || number == 0 || number > 65535) {
    return wrong("the port is not a number from 1 to 65535");
  }
  return Endpoint{std::string{host}, std::string{port}};
}

}  // namespace talus::cli
