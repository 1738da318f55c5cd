// Clients' addresses, as logs show them.
#pragma once

#include <string>

#include <asio/ip/address.hpp>

namespace talus::server {

/// A listener on `[::]` sees IPv4 clients at addresses mapped into IPv6: the IPv4 address of such a client,
/// and any other address itself.
[[nodiscard]] inline asio::ip::address unmapped(const asio::ip::address& address) {
  if (address.is_v4() || !address.to_v6().is_v4_mapped()) return address;
  return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6());
}

[[nodiscard]] inline std::string address_text(const asio::ip::address& address) {
  return unmapped(address).to_string();
}

}  // namespace talus::server
