// Parses HTTP/1.0 and 1.1 requests incrementally, from pieces of any size. No I/O; http_parser does the
// grammar. Source: RFC 9112 (HTTP/1.1), RFC 9110 (HTTP semantics).
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include <tl/expected.hpp>

#include "net/http/request.h"

namespace talus::server::http {

/// A request beyond these bounds is an error; the excess is not stored.
struct RequestBounds {
  std::size_t target_bytes = 1024;
  std::size_t fields = 64;
  std::size_t field_bytes = 4096;        // name and value
  std::size_t head_bytes = 16UL * 1024;  // of the whole head
};

class RequestParser {
 public:
  explicit RequestParser(const RequestBounds& bounds = {});
  ~RequestParser();
  RequestParser(const RequestParser&) = delete;
  RequestParser& operator=(const RequestParser&) = delete;

  /// Consumes bytes up to the end of one request and returns their number. Call it with the rest after pop().
  /// After an error it only returns the error.
  [[nodiscard]] tl::expected<std::size_t, RequestError> feed(std::span<const std::byte> bytes);

  [[nodiscard]] bool has_request() const;
  /// Returns true after part of a request was consumed.
  [[nodiscard]] bool mid_request() const;
  /// Only if has_request().
  [[nodiscard]] const Request& request() const;
  /// Size of that request as it was sent.
  [[nodiscard]] std::size_t head_bytes() const;
  /// Drops the request; the next one begins.
  void pop();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace talus::server::http
