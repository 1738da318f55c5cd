// Pages of which origins may read chunks and open streams. Pure. Source: RFC 6454, and CORS of the Fetch
// standard.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace talus::server {

class AllowedOrigins {
 public:
  /// The page's own host alone.
  AllowedOrigins() = default;

  /// "https://play.example, http://localhost:5173", "*" for all, or "" for the page's own host alone. An
  /// error is one line that names the wrong part.
  [[nodiscard]] static tl::expected<AllowedOrigins, std::string> parse(std::string_view text);

  /// `host`: the request's Host field.
  [[nodiscard]] bool allow(std::string_view origin, std::string_view host) const;
  /// Whether it is one of those given by name.
  [[nodiscard]] bool lists(std::string_view origin) const;
  [[nodiscard]] bool all() const { return all_; }
  /// Whether it is as it was made: nobody has said which.
  [[nodiscard]] bool unset() const { return !all_ && origins_.empty(); }
  /// As parse() takes it.
  [[nodiscard]] const std::string& text() const { return text_; }
  bool operator==(const AllowedOrigins&) const = default;

 private:
  std::string text_;
  std::vector<std::string> origins_;
  bool all_ = false;
};

}  // namespace talus::server
