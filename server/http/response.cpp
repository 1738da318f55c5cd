#include "http/response.h"

#include <iterator>

#include <fmt/format.h>
#include <http_parser.h>

#include "log/utc_time.h"

namespace talus::server::http {

Response response_to(const RequestError& error) {
  return {error.status, kPlainText, fmt::format("{}\n", error.text)};
}

std::string head_of(const Response& response, bool keep_alive, std::chrono::sys_seconds date) {
  std::string head = fmt::format(
      "HTTP/1.1 {} {}\r\nDate: {} GMT\r\nContent-Type: {}\r\nContent-Length: {}\r\n"
      "Cache-Control: no-store\r\nConnection: {}\r\n",
      response.status, http_status_str(static_cast<http_status>(response.status)),
      utc_time(date, "%a, %d %b %Y %H:%M:%S"), response.content_type, response.body.size(),
      keep_alive ? "keep-alive" : "close");
  for (const Field& field : response.fields) {
    fmt::format_to(std::back_inserter(head), "{}: {}\r\n", field.name, field.value);
  }
  return head += "\r\n";
}

}  // namespace talus::server::http
