#include "net/proxy_header.h"

#include <algorithm>
#include <array>

namespace talus::server {
namespace {

constexpr std::array<unsigned char, 12> kSignature{0x0D, 0x0A, 0x0D, 0x0A, 0x00, 0x0D,
                                                   0x0A, 0x51, 0x55, 0x49, 0x54, 0x0A};
constexpr std::size_t kTcp4Bytes = 12;
constexpr std::size_t kTcp6Bytes = 36;

std::uint16_t big_endian(std::span<const std::byte> bytes) {
  return static_cast<std::uint16_t>(std::to_integer<unsigned>(bytes[0]) << 8 |
                                    std::to_integer<unsigned>(bytes[1]));
}

template <typename Address>
asio::ip::tcp::endpoint source(std::span<const std::byte> body) {
  typename Address::bytes_type bytes{};
  std::transform(body.begin(), body.begin() + bytes.size(), bytes.begin(),
                 [](std::byte byte) { return std::to_integer<std::uint8_t>(byte); });
  // Source and destination address, source and destination port.
  return {Address{bytes}, big_endian(body.subspan(2 * bytes.size(), 2))};
}

}  // namespace

tl::expected<ProxyPrefix, std::string_view> read_proxy_prefix(
    std::span<const std::byte, kProxyPrefixBytes> bytes) {
  using Origin = ProxyPrefix::Origin;
  const auto wrong = [](std::string_view what) { return tl::make_unexpected(what); };
  const bool is_signature =
      std::equal(kSignature.begin(), kSignature.end(), bytes.begin(),
                 [](unsigned char right, std::byte byte) { return std::byte{right} == byte; });
  if (!is_signature) return wrong("sent no PROXY header of version 2");
  if (std::to_integer<unsigned>(bytes[12]) >> 4 != 2)
    return wrong("sent a PROXY header of another version than 2");
  const unsigned command = std::to_integer<unsigned>(bytes[12]) & 15U;
  const unsigned family = std::to_integer<unsigned>(bytes[13]);
  ProxyPrefix prefix{Origin::peer, big_endian(bytes.subspan<14, 2>())};
  if (command > 1) return wrong("sent a PROXY header with an unknown command");
  if (prefix.body_bytes > kMaxProxyBodyBytes) return wrong("sent a PROXY header of over 1,024 bytes");
  if (command == 0 || family == 0x00) return prefix;
  if (family != 0x11 && family != 0x21)
    return wrong("sent a PROXY header of neither TCP over IPv4 nor over IPv6");
  prefix.origin = family == 0x11 ? Origin::tcp4 : Origin::tcp6;
  if (prefix.body_bytes < (family == 0x11 ? kTcp4Bytes : kTcp6Bytes)) {
    return wrong("sent a PROXY header too short for its addresses");
  }
  return prefix;
}

std::uint16_t proxied_port(const ProxyPrefix& prefix, std::span<const std::byte> body) {
  switch (prefix.origin) {
    case ProxyPrefix::Origin::tcp4:
      return big_endian(body.subspan(kTcp4Bytes - 2, 2));
    case ProxyPrefix::Origin::tcp6:
      return big_endian(body.subspan(kTcp6Bytes - 2, 2));
    case ProxyPrefix::Origin::peer:
      break;
  }
  return 0;
}

std::optional<asio::ip::tcp::endpoint> proxied_client(const ProxyPrefix& prefix,
                                                      std::span<const std::byte> body) {
  switch (prefix.origin) {
    case ProxyPrefix::Origin::tcp4:
      return source<asio::ip::address_v4>(body);
    case ProxyPrefix::Origin::tcp6:
      return source<asio::ip::address_v6>(body);
    case ProxyPrefix::Origin::peer:
      break;
  }
  return std::nullopt;
}

}  // namespace talus::server
