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

class Networks {
 public:
  static constexpr std::size_t kMax = 256;

  /// No networks.
  Networks() = default;

  /// "10.0.0.0/8, 192.0.2.7, 2001:db8::/32", or "" for none. An address without a length is a network of
  /// itself; the bits after the length must be zero. An error is one line that names the wrong part.
  [[nodiscard]] static tl::expected<Networks, std::string> parse(std::string_view text);

  /// An IPv4 address and the same address mapped into IPv6 are equal.
  [[nodiscard]] bool contain(const asio::ip::address& address) const;
  [[nodiscard]] bool empty() const { return networks_.empty(); }

  bool operator==(const Networks&) const = default;

 private:
  std::vector<asio::ip::network_v6> networks_;  // IPv4 networks are mapped into IPv6
};

}  // namespace talus::server
