// An HTTP/1 request without a body: this server accepts no bodies.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace talus::server::http {

struct Field {
  std::string name;
  std::string value;
};

enum class Method : std::uint8_t { get, head, options, other };

struct Request {
  Method method = Method::other;
  std::string target;  // as sent: path and query, or a full URL
  std::vector<Field> fields;
  bool keep_alive = false;  // another request may follow
  bool upgrade = false;     // the client asks for another protocol after this request

  /// The target's path, without host and query. Source: RFC 9112, 3.2.1 and 3.2.2.
  [[nodiscard]] std::string_view path() const;
  /// The part after the target's first '?'; nullopt without one.
  [[nodiscard]] std::optional<std::string_view> query() const;
  /// True if there is a field with this name, in any case.
  [[nodiscard]] bool has(std::string_view name) const;
  /// The values of all fields with this name as one list, in order; empty if there is no such field. Source:
  /// RFC 9110, 5.2.
  [[nodiscard]] std::string list(std::string_view name) const;
  /// Token of `Authorization: Bearer`, in any case; empty if missing. Source: RFC 6750, 2.1; RFC 9110, 11.1.
  [[nodiscard]] std::string bearer_token() const;
};

/// Reason for rejecting a request. The connection closes, as the beginning of the next request is unknown.
struct RequestError {
  int status = 400;
  std::string_view text;  // one line
};

}  // namespace talus::server::http
