#include "http/response.h"

#include <iterator>

#include <fmt/format.h>
#include <http_parser.h>

#include "log/utc_time.h"

namespace talus::server::http {
namespace {

/// RFC 9110, 5.6.7. A busy thread makes it once a second.
const std::string& date_text(std::chrono::sys_seconds date) {
  thread_local std::chrono::sys_seconds last = std::chrono::sys_seconds::max();
  thread_local std::string text;
  if (date != last) text = utc_time(date, "%a, %d %b %Y %H:%M:%S");
  last = date;
  return text;
}

std::string_view connection_field(int status, bool keep_alive) {
  if (status == 101) return "Upgrade";
  return keep_alive ? "keep-alive" : "close";
}

}  // namespace

Response response_to(const RequestError& error) {
  return {error.status, kPlainText, fmt::format("{}\n", error.text)};
}

void append_head(std::string& output, const Response& response, bool keep_alive,
                 std::chrono::sys_seconds date) {
  const auto into = std::back_inserter(output);
  fmt::format_to(into, "HTTP/1.1 {} {}\r\nDate: {} GMT\r\n", response.status,
                 http_status_str(static_cast<http_status>(response.status)), date_text(date));
  if (response.status != 101 && response.status != 204 && response.status != 304) {
    fmt::format_to(into, "Content-Type: {}\r\nContent-Length: {}\r\n", response.content_type,
                   response.content().size());
  }
  if (response.status != 101) fmt::format_to(into, "Cache-Control: {}\r\n", response.cache_control);
  fmt::format_to(into, "Connection: {}\r\n", connection_field(response.status, keep_alive));
  for (const Field& field : response.fields) fmt::format_to(into, "{}: {}\r\n", field.name, field.value);
  output += "\r\n";
}

}  // namespace talus::server::http
