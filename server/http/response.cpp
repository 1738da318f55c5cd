#include "http/response.h"

#include <array>
#include <charconv>

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
  const auto append = [&output](auto... parts) { (output.append(parts), ...); };
  const auto number = [](std::array<char, 20>& digits, std::size_t value) {
    char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return std::string_view{digits.data(), static_cast<std::size_t>(end - digits.data())};
  };
  std::array<char, 20> digits{};
  append("HTTP/1.1 ", number(digits, static_cast<std::size_t>(response.status)), " ",
         http_status_str(static_cast<http_status>(response.status)),
         "\r\nDate: ", std::string_view{date_text(date)}, " GMT\r\n");
  if (response.status != 101 && response.status != 204 && response.status != 304) {
    append("Content-Type: ", response.content_type,
           "\r\nContent-Length: ", number(digits, response.body.size()), "\r\n");
  }
  if (response.status != 101) append("Cache-Control: ", response.cache_control, "\r\n");
  append("Connection: ", connection_field(response.status, keep_alive), "\r\n");
  for (const Field& field : response.fields) {
    append(std::string_view{field.name}, ": ", std::string_view{field.value}, "\r\n");
  }
  output += "\r\n";
}

}  // namespace talus::server::http
