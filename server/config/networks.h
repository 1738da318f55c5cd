// A list of networks as people write it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <asio/ip/address.hpp>
#include <tl/expected.hpp>

namespace talus::server {

class Networks {
 public:
  static constexpr std::size_t kMost = 256;

  /// Of nothing.
  Networks() = default;

  /// "10.0.0.0/8, 192.0.2.7, 2001:db8::/32", or "" for none; else a line that says which part is wrong. An
  /// address without a length stands for itself; bits beyond the length must be zero.
  [[nodiscard]] static tl::expected<Networks, std::string> parse(std::string_view text);

  /// An IPv4 address counts the same when it comes mapped into IPv6.
  [[nodiscard]] bool contain(const asio::ip::address& address) const;
  [[nodiscard]] bool empty() const { return networks_.empty(); }

  bool operator==(const Networks&) const = default;

 private:
  /// IPv4 is kept as IPv6 does: mapped, 96 bits longer.
  using Bytes = std::array<std::uint8_t, 16>;
  struct Network {
    Bytes first{};
    unsigned bits = 0;
    bool operator==(const Network&) const = default;
  };
  [[nodiscard]] static Bytes bytes_of(const asio::ip::address& address);
  [[nodiscard]] static Bytes cut(Bytes bytes, unsigned bits);
  [[nodiscard]] static tl::expected<Network, std::string> parse_one(std::string_view text);

  std::vector<Network> networks_;
};

}  // namespace talus::server
