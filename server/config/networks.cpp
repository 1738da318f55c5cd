#include "config/networks.h"

#include <algorithm>

#include <fmt/format.h>
#include <asio/error.hpp>
#include <asio/ip/network_v4.hpp>

#include "runtime/log/escape.h"

#include "config/trimmed.h"

namespace talus::server {
namespace {

namespace ip = asio::ip;

constexpr int kMappedBits = 96;

}  // namespace

ip::address_v6 mapped(const ip::address& address) {
  return address.is_v4() ? ip::make_address_v6(ip::v4_mapped, address.to_v4())
                         : ip::address_v6{address.to_v6().to_bytes()};
}

tl::expected<ip::network_v6, std::string> parse_network(std::string_view text) {
  const auto wrong = [&](std::string_view what) {
    return tl::make_unexpected(fmt::format("\"{}\" {}", escaped(text), what));
  };
  const std::size_t slash = text.find('/');
  std::error_code error;
  const ip::address address = ip::make_address(text.substr(0, slash), error);
  if (error || (address.is_v6() && address.to_v6().scope_id() != 0)) return wrong("is not an address");
  const int longest = address.is_v4() ? 32 : 128;
  constexpr std::size_t kMaxDigits = 3;  // Asio parses the length by atoi, which overflows on more digits
  int length = longest;
  if (slash != std::string_view::npos && text.size() - slash - 1 <= kMaxDigits) {
    length = address.is_v4() ? ip::make_network_v4(text, error).prefix_length()
                             : ip::make_network_v6(text, error).prefix_length();
  } else if (slash != std::string_view::npos) {
    error = asio::error::invalid_argument;
  }
  if (error) return wrong(fmt::format("has no length from 0 to {} after its /", longest));
  const ip::network_v6 network{mapped(address),
                               static_cast<unsigned short>(length + (address.is_v4() ? kMappedBits : 0))};
  if (network.canonical() != network) return wrong("has bits set after its length");
  return network;
}

tl::expected<Networks, std::string> Networks::parse(std::string_view text) {
  Networks networks;
  if (trimmed(text).empty()) return networks;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    auto network = parse_network(trimmed(text.substr(from, comma - from)));
    if (!network) {
      return tl::make_unexpected(network.error() +
                                 "; write addresses and networks separated by commas, as in 10.0.0.0/8, "
                                 "192.0.2.7, 2001:db8::/32");
    }
    if (networks.networks_.size() == kMax) {
      return tl::make_unexpected(fmt::format("the list has more than {} networks; combine some", kMax));
    }
    networks.networks_.push_back(*network);
    from = comma + 1;
  }
  return networks;
}

std::string Networks::text() const {
  std::string text;
  for (const ip::network_v6& network : networks_) {
    if (!text.empty()) text += ", ";
    const ip::address_v6 address = network.address();
    const bool v4 = address.is_v4_mapped() && network.prefix_length() >= kMappedBits;
    text += v4 ? fmt::format("{}/{}", ip::make_address_v4(ip::v4_mapped, address).to_string(),
                             network.prefix_length() - kMappedBits)
               : network.to_string();
  }
  return text;
}

bool Networks::contain(const asio::ip::address& address) const {
  const ip::address_v6 host = mapped(address);
  return std::any_of(networks_.begin(), networks_.end(), [&](const ip::network_v6& network) {
    return ip::network_v6{host, network.prefix_length()}.canonical() == network;
  });
}

}  // namespace talus::server
