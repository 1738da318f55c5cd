// An HTTP/1.1 response as bytes. No I/O.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "net/http/body_source.h"
#include "net/http/request.h"

namespace talus::server::http {

inline constexpr const char* kPlainText = "text/plain; charset=utf-8";
/// For Cache-Control. No cache keeps the response; or it asks before each use whether it is still right.
inline constexpr std::string_view kNoStore = "no-store";
inline constexpr std::string_view kNoCache = "no-cache";

/// The value of an ETag field, its quotes included: 128 bits in hex.
using EntityTag = std::array<char, 34>;
[[nodiscard]] inline std::string_view text_of(const EntityTag& tag) {
  return {tag.data(), tag.size()};
}

struct Response {
  int status = 200;
  std::string_view content_type = kPlainText;  // lives as long as the program
  std::string body{};
  std::vector<Field> fields{};  // beside those of which this knows
  std::string_view cache_control = kNoStore;
  std::string_view kept{};  // a body that the handler keeps as long as it lives; `body` is empty then

  std::optional<EntityTag> etag{};
  bool any_origin = false;  // pages of every origin may read it

  bool last = false;  // the connection closes after it

  std::shared_ptr<BodySource> source{};  // null: the body is content()

  [[nodiscard]] std::string_view content() const { return kept.empty() ? std::string_view{body} : kept; }
  [[nodiscard]] std::uint64_t size() const { return source == nullptr ? content().size() : source->size(); }
};

/// What a request that is no request gets.
[[nodiscard]] Response response_to(const RequestError& error);

/// Appends all before the body, which follows unless the request was HEAD: Content-Length is the body's then
/// too. Responses 101, 204 and 304 have no body and no word of one. `date`: now.
void append_head(std::string& output, const Response& response, bool keep_alive,
                 std::chrono::sys_seconds date);

}  // namespace talus::server::http
