// Origins whose pages may read chunks and open streams. Pure. Source: RFC 6454, and CORS of the Fetch
// standard.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace talus::server {

class AllowedOrigins {
 public:
  /// Allows only the page's own host.
  AllowedOrigins() = default;

  /// Parses "https://play.example, http://localhost:5173", "*" for all, or "" for only the page's own host.
  /// An error is one line that names the wrong part.
  [[nodiscard]] static tl::expected<AllowedOrigins, std::string> parse(std::string_view text);

  /// Also allows pages of this machine: localhost, its subdomains, and loopback addresses.
  void allow_loopback() { loopback_ = true; }

  /// Compares as URLs are compared: case, a dot at the end and default ports make no difference. `host` is
  /// the request's Host field; its scheme is the origin's, as a proxy may speak TLS.
  [[nodiscard]] bool allow(std::string_view origin, std::string_view host) const;
  /// True if the origin is listed, and spelled as browsers spell it.
  [[nodiscard]] bool lists(std::string_view origin) const;
  [[nodiscard]] bool all() const { return all_; }
  /// True if neither "*" nor any origin was given.
  [[nodiscard]] bool unset() const { return !all_ && origins_.empty(); }
  /// Inverse of parse().
  [[nodiscard]] const std::string& text() const { return text_; }
  bool operator==(const AllowedOrigins&) const = default;

 private:
  std::string text_;
  std::vector<std::string> origins_;  // as browsers spell them
  bool all_ = false;
  bool loopback_ = false;
};

/// True for localhost, its subdomains, and loopback addresses; an IPv6 address may have brackets.
[[nodiscard]] bool is_loopback(std::string_view host);

}  // namespace talus::server
