// Reads HTTP/1.0 and 1.1 requests from bytes, however they are cut. No I/O; http_parser does the grammar.
// Source: RFC 9112 (HTTP/1.1), RFC 9110 (HTTP semantics).
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include <tl/expected.hpp>

#include "net/http/request.h"

namespace talus::server::http {

/// Beyond them a request is an error, and no more of it is kept.
struct RequestBounds {
  std::size_t target_bytes = 1024;
  std::size_t fields = 64;
  std::size_t field_bytes = 4096;        // name and value
  std::size_t head_bytes = 16UL * 1024;  // all of it
};

class RequestParser {
 public:
  explicit RequestParser(const RequestBounds& bounds = {});
  ~RequestParser();
  RequestParser(const RequestParser&) = delete;
  RequestParser& operator=(const RequestParser&) = delete;

  /// Takes bytes up to the end of one request; returns how many. Call it again with the rest after pop().
  /// After an error nothing more can be fed.
  [[nodiscard]] tl::expected<std::size_t, RequestError> feed(std::span<const std::byte> bytes);

  [[nodiscard]] bool has_request() const;
  /// Whether bytes of a request have come that is not yet whole.
  [[nodiscard]] bool mid_request() const;
  /// Only while has_request().
  [[nodiscard]] const Request& request() const;
  /// Forgets the request: the next one begins.
  void pop();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace talus::server::http
