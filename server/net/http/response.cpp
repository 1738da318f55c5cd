#include "net/http/response.h"

#include <array>
#include <charconv>
#include <iterator>

#include <fmt/format.h>
#include <http_parser.h>

#include "runtime/log/utc_time.h"

namespace talus::server::http {
namespace {

bool has_body(int status) {
  return status != 101 && status != 204 && status != 304;
}

std::string_view connection_field(int status, bool keep_alive) {
  if (status == 101) return "Upgrade";
  if (status == 426) return "Upgrade, close";
  return keep_alive ? "keep-alive" : "close";
}

/// Returns the lines shared by consecutive responses. A busy thread formats them once a second.
const std::string& same_lines(const Response& response, bool keep_alive, std::chrono::sys_seconds date) {
  struct Lines {
    std::chrono::sys_seconds date = std::chrono::sys_seconds::max();
    int status = 0;
    bool keep_alive = false;
    bool any_origin = false;
    std::string_view content_type, cache_control;  // constants
    std::string text;
  };
  thread_local Lines last;
  const auto same_view = [](std::string_view a, std::string_view b) {
    return a.data() == b.data() && a.size() == b.size();
  };
  if (last.date == date && last.status == response.status && last.keep_alive == keep_alive &&
      last.any_origin == response.any_origin && same_view(last.content_type, response.content_type) &&
      same_view(last.cache_control, response.cache_control)) {
    return last.text;
  }
  last = {
      date, response.status, keep_alive, response.any_origin, response.content_type, response.cache_control,
      {}};
  const auto into = std::back_inserter(last.text);
  fmt::format_to(into, "HTTP/1.1 {} {}\r\nDate: {} GMT\r\n", response.status,
                 http_status_str(static_cast<http_status>(response.status)),
                 utc_time(date, "%a, %d %b %Y %H:%M:%S"));
  if (has_body(response.status)) fmt::format_to(into, "Content-Type: {}\r\n", response.content_type);
  if (response.status != 101) fmt::format_to(into, "Cache-Control: {}\r\n", response.cache_control);
  if (response.any_origin) last.text += "Access-Control-Allow-Origin: *\r\n";
  fmt::format_to(into, "Connection: {}\r\n", connection_field(response.status, keep_alive));
  return last.text;
}

}  // namespace

Response response_to(const RequestError& error) {
  return {error.status, kPlainText, fmt::format("{}\n", error.text)};
}

void append_head(std::string& output, const Response& response, bool keep_alive,
                 std::chrono::sys_seconds date) {
  output += same_lines(response, keep_alive, date);
  if (has_body(response.status)) {
    std::array<char, 20> digits{};
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), response.size()).ptr;
    output += "Content-Length: ";
    output += std::string_view{digits.data(), static_cast<std::size_t>(end - digits.data())};
    output += "\r\n";
  }
  if (response.etag) {
    output += "ETag: ";
    output += text_of(*response.etag);
    output += "\r\n";
  }
  for (const Field& field : response.fields) {
    output += field.name;
    output += ": ";
    output += field.value;
    output += "\r\n";
  }
  output += "\r\n";
}

}  // namespace talus::server::http
