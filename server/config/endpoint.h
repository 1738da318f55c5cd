// HOST:PORT as people write it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server {

/// A host name or an address, and a port; port 0 lets the system choose one.
struct Endpoint {
  std::string host;
  std::uint16_t port = 0;
  bool operator==(const Endpoint&) const = default;
};

/// "127.0.0.1:4780", "localhost:4780" or "[::]:4780"; else a line that says what is wrong.
[[nodiscard]] tl::expected<Endpoint, std::string> parse_endpoint(std::string_view text);

/// The form that parse_endpoint reads, with brackets around an IPv6 address.
[[nodiscard]] std::string to_string(const Endpoint& endpoint);

}  // namespace talus::server
