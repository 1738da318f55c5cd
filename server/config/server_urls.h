// Addresses of other servers, in the form SCHEME://HOST:PORT. Pure.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace talus::server {

class ServerUrls {
 public:
  static constexpr std::size_t kMax = 32;

  ServerUrls() = default;

  /// Parses "nats://10.0.0.1:4222, nats://10.0.0.2:4222", or "" for an empty list. All must have the same
  /// scheme from `schemes` ("nats"), a host and a port, and nothing else: secrets do not belong in addresses.
  /// An error is one line that names the wrong part.
  [[nodiscard]] static tl::expected<ServerUrls, std::string> parse(std::string_view text,
                                                                   std::span<const std::string_view> schemes);

  [[nodiscard]] bool empty() const { return urls_.empty(); }
  [[nodiscard]] std::size_t size() const { return urls_.size(); }
  /// Returns a list of only that address.
  [[nodiscard]] ServerUrls just(std::size_t which) const;
  [[nodiscard]] auto begin() const { return urls_.begin(); }
  [[nodiscard]] auto end() const { return urls_.end(); }
  /// "nats"; empty if the list is empty.
  [[nodiscard]] std::string_view scheme() const;
  /// Inverse of parse().
  [[nodiscard]] std::string text() const;

  bool operator==(const ServerUrls&) const = default;

 private:
  std::vector<std::string> urls_;
};

}  // namespace talus::server
