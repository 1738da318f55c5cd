// The PROXY protocol, version 2: the bytes before a connection's own, in which a proxy says for whom it
// speaks. Pure functions. Source: The PROXY protocol, versions 1 & 2 (HAProxy, 2020), section 2.2.
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
/// Of what follows the prefix: an address, and whatever else proxies add. 520 must be taken (section 2.2).
inline constexpr std::size_t kMaxProxyBodyBytes = 1024;

/// What the first 16 bytes say of the rest.
struct ProxyPrefix {
  enum class Origin : std::uint8_t {
    peer,  // the proxy speaks for itself, or does not say for whom
    tcp4,
    tcp6,
  };
  Origin origin{};
  std::uint16_t body_bytes = 0;  // at most kMaxProxyBodyBytes
};

/// The error says what is wrong, as the end of a sentence about the peer.
[[nodiscard]] tl::expected<ProxyPrefix, std::string_view> read_proxy_prefix(
    std::span<const std::byte, kProxyPrefixBytes> bytes);

/// Who is behind the proxy; none where that is the proxy itself. `body` has prefix.body_bytes bytes.
[[nodiscard]] std::optional<asio::ip::tcp::endpoint> proxied_client(const ProxyPrefix& prefix,
                                                                    std::span<const std::byte> body);

/// The port to which that client came at the proxy; 0 where the proxy speaks for itself.
[[nodiscard]] std::uint16_t proxied_port(const ProxyPrefix& prefix, std::span<const std::byte> body);

}  // namespace talus::server
