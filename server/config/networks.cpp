#include "config/networks.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "log/escape.h"

namespace talus::server {
namespace {

constexpr unsigned kMappedBits = 96;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

Networks::Bytes Networks::bytes_of(const asio::ip::address& address) {
  return address.is_v6() ? address.to_v6().to_bytes()
                         : asio::ip::make_address_v6(asio::ip::v4_mapped, address.to_v4()).to_bytes();
}

Networks::Bytes Networks::cut(Bytes bytes, unsigned bits) {
  for (unsigned i = 0; i < bytes.size(); ++i) {
    const unsigned kept = bits <= 8 * i ? 0 : std::min(8U, bits - 8 * i);
    bytes[i] = static_cast<std::uint8_t>(bytes[i] & (0xFF00U >> kept));
  }
  return bytes;
}

tl::expected<Networks::Network, std::string> Networks::parse_one(std::string_view text) {
  const auto wrong = [&](std::string_view what) {
    return tl::make_unexpected(
        fmt::format("\"{}\" {}; write addresses and networks with commas between, as in 10.0.0.0/8, "
                    "192.0.2.7, 2001:db8::/32",
                    escaped(text), what));
  };
  const std::size_t slash = text.find('/');
  std::error_code error;
  const auto address = asio::ip::make_address(text.substr(0, slash), error);
  if (error || (address.is_v6() && address.to_v6().scope_id() != 0)) return wrong("is no address");
  const unsigned longest = address.is_v4() ? 32 : 128;
  unsigned bits = longest;
  if (slash != std::string_view::npos) {
    const std::string_view digits = text.substr(slash + 1);
    const char* const end = digits.data() + digits.size();
    const auto [stop, failed] = std::from_chars(digits.data(), end, bits);
    if (digits.empty() || failed != std::errc{} || stop != end || bits > longest) {
      return wrong(fmt::format("has no length from 0 to {} after its /", longest));
    }
  }
  const Network network{bytes_of(address), bits + (address.is_v4() ? kMappedBits : 0)};
  if (cut(network.first, network.bits) != network.first) {
    return wrong("has bits set beyond its length");
  }
  return network;
}

tl::expected<Networks, std::string> Networks::parse(std::string_view text) {
  Networks networks;
  if (trimmed(text).empty()) return networks;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    auto network = parse_one(trimmed(text.substr(from, comma - from)));
    if (!network) return tl::make_unexpected(network.error());
    if (networks.networks_.size() == kMost) {
      return tl::make_unexpected(fmt::format("the list has more than {} networks; join some", kMost));
    }
    networks.networks_.push_back(*network);
    from = comma + 1;
  }
  return networks;
}

bool Networks::contain(const asio::ip::address& address) const {
  const Bytes bytes = bytes_of(address);
  for (const Network& network : networks_) {
    if (cut(bytes, network.bits) == network.first) return true;
  }
  return false;
}

}  // namespace talus::server
