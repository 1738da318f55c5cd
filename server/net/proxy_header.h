// The PROXY protocol, version 2: bytes before a connection's own, in which a proxy names its client. Pure
// functions. Source: The PROXY protocol, versions 1 & 2 (HAProxy, 2020), section 2.2.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <asio/ip/tcp.hpp>
#include <tl/expected.hpp>

namespace talus::server {

inline constexpr std::size_t kProxyPrefixBytes = 16;
/// Limit of the bytes after the prefix: an address and extensions of proxies. At least 520 are required
/// (section 2.2).
inline constexpr std::size_t kMaxProxyBodyBytes = 1024;

/// The first 16 bytes, which describe the rest.
struct ProxyPrefix {
  enum class Origin : std::uint8_t {
    peer,  // the proxy itself, or unspecified
    tcp4,
    tcp6,
  };
  Origin origin{};
  std::uint16_t body_bytes = 0;  // at most kMaxProxyBodyBytes
};

/// The error is phrased as the end of a sentence about the peer.
[[nodiscard]] tl::expected<ProxyPrefix, std::string_view> read_proxy_prefix(
    std::span<const std::byte, kProxyPrefixBytes> bytes);

/// The client behind the proxy; nullopt for the proxy's own connection. `body` has prefix.body_bytes bytes.
[[nodiscard]] std::optional<asio::ip::tcp::endpoint> proxied_client(const ProxyPrefix& prefix,
                                                                    std::span<const std::byte> body);

/// The proxy's port to which the client connected; 0 for the proxy's own connection.
[[nodiscard]] std::uint16_t proxied_port(const ProxyPrefix& prefix, std::span<const std::byte> body);

}  // namespace talus::server
