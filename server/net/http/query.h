// Parses the query of an HTTP request. Pure. Source: the URL standard, "application/x-www-form-urlencoded".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace talus::server::http {

/// Splits at `by` into at most `max_parts`; the last part has the rest.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char by, std::size_t max_parts);

/// Replaces %XX by its byte; nullopt if two hexadecimal digits do not follow a %.
[[nodiscard]] std::optional<std::string> percent_decoded(std::string_view text);
/// Replaces %XX by its byte and + by a blank; nullopt if two hexadecimal digits do not follow a %.
[[nodiscard]] std::optional<std::string> form_decoded(std::string_view text);

/// Keys and values of a query.
class Query {
 public:
  struct Pair {
    std::string key;
    std::string value;
    std::string_view raw;  // the value as sent, a view into the query
  };

  /// The error is one line.
  [[nodiscard]] static tl::expected<Query, std::string> parse(std::string_view text);

  /// Removes the first pair with the key; nullopt if the key is missing.
  [[nodiscard]] std::optional<Pair> take(std::string_view key);
  /// The pairs that were not taken.
  [[nodiscard]] const std::vector<Pair>& left() const { return pairs_; }

 private:
  std::vector<Pair> pairs_;
};

}  // namespace talus::server::http
