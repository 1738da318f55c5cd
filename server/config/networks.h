// A list of networks in CIDR notation.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <asio/ip/address.hpp>
#include <asio/ip/network_v6.hpp>
#include <tl/expected.hpp>

namespace talus::server {

/// Parses an address or a network in CIDR notation, mapping IPv4 into IPv6. An address alone is a network of
/// itself; bits after the prefix must be zero. An error is one line that quotes the text.
[[nodiscard]] tl::expected<asio::ip::network_v6, std::string> parse_network(std::string_view text);

/// Maps an IPv4 address into IPv6; removes the scope of others, which networks lack.
[[nodiscard]] asio::ip::address_v6 mapped(const asio::ip::address& address);

class Networks {
 public:
  static constexpr std::size_t kMax = 256;

  Networks() = default;

  /// Parses "10.0.0.0/8, 192.0.2.7, 2001:db8::/32" or "". An error is one line that names the wrong part.
  [[nodiscard]] static tl::expected<Networks, std::string> parse(std::string_view text);

  /// An IPv4 address equals the same address mapped into IPv6.
  [[nodiscard]] bool contain(const asio::ip::address& address) const;
  [[nodiscard]] bool empty() const { return networks_.empty(); }
  /// Inverse of parse().
  [[nodiscard]] std::string text() const;

  bool operator==(const Networks&) const = default;

 private:
  std::vector<asio::ip::network_v6> networks_;  // IPv4 networks are mapped into IPv6
};

}  // namespace talus::server
