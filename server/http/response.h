// An HTTP/1.1 response as bytes. No I/O.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "http/request.h"

namespace talus::server::http {

inline constexpr const char* kPlainText = "text/plain; charset=utf-8";

struct Response {
  int status = 200;
  std::string content_type = kPlainText;
  std::string body{};
  std::vector<Field> fields{};  // beside Date, Content-Type, Content-Length, Cache-Control and Connection
};

/// What a request that is no request gets.
[[nodiscard]] Response response_to(const RequestError& error);

/// All before the body, which follows unless the request was HEAD: Content-Length is the body's then too.
/// No cache may keep the response. `date`: now.
[[nodiscard]] std::string head_of(const Response& response, bool keep_alive, std::chrono::sys_seconds date);

}  // namespace talus::server::http
