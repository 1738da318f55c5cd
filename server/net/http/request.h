// An HTTP/1 request, without a body: this server takes none.
#pragma once

#include <cstdint>
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
  std::string target;  // as sent: path and query, or a whole URL
  std::vector<Field> fields;
  bool keep_alive = false;  // whether another request may follow
  bool upgrade = false;     // whether the client asks for another protocol from here on

  /// The target's path, without host and query. Source: RFC 9112, 3.2.1 and 3.2.2.
  [[nodiscard]] std::string_view path() const;
  /// What follows the target's first '?'; empty: nothing.
  [[nodiscard]] std::string_view query() const;
  /// The value of the first field of this name, in any case; null where there is none.
  [[nodiscard]] const std::string* field(std::string_view name) const;
  /// The values of all fields of this name as one list, in order. Source: RFC 9110, 5.2. Empty: there is
  /// none.
  [[nodiscard]] std::string list(std::string_view name) const;
  /// Of `Authorization: Bearer`, in any case; empty: there is none. Source: RFC 6750, 2.1; RFC 9110, 11.1.
  [[nodiscard]] std::string_view bearer_token() const;
};

/// Why a request cannot be answered as asked. The connection closes: where the next request would begin is
/// not known.
struct RequestError {
  int status = 400;
  std::string_view text;  // one line
};

}  // namespace talus::server::http
