// HOST:PORT notation of a server's address.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::protocol {

/// A host name or an address, and a port. Port 0 is for servers: the system chooses one.
struct Endpoint {
  std::string host;
  std::uint16_t port = 0;
  bool operator==(const Endpoint&) const = default;
};

/// Parses "127.0.0.1:4780", "localhost:4780" or "[::]:4780". The error states what is wrong and what is
/// expected, without repeating `text`: the caller names the option or setting.
[[nodiscard]] tl::expected<Endpoint, std::string> parse_endpoint(std::string_view text);

/// The notation that parse_endpoint() reads, with brackets around an IPv6 address.
[[nodiscard]] std::string to_string(const Endpoint& endpoint);

}  // namespace talus::protocol
