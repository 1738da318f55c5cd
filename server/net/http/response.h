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
/// Values of Cache-Control. kNoStore: not cached; kNoCache: cached, but revalidated before each use.
inline constexpr std::string_view kNoStore = "no-store";
inline constexpr std::string_view kNoCache = "no-cache";

/// The value of an ETag field with its quotes: 128 bits in hex.
using EntityTag = std::array<char, 34>;
[[nodiscard]] inline std::string_view text_of(const EntityTag& tag) {
  return {tag.data(), tag.size()};
}

struct Response {
  int status = 200;
  std::string_view content_type = kPlainText;  // of static lifetime
  std::string body{};
  std::vector<Field> fields{};  // in addition to the fields below
  std::string_view cache_control = kNoStore;
  std::string_view kept{};  // a body owned by the handler; if set, `body` is empty

  std::optional<EntityTag> etag{};
  bool any_origin = false;  // pages of every origin may read it

  bool last = false;  // the connection closes after it

  std::shared_ptr<BodySource> source{};  // null: the body is content()

  [[nodiscard]] std::string_view content() const { return kept.empty() ? std::string_view{body} : kept; }
  [[nodiscard]] std::uint64_t size() const { return source == nullptr ? content().size() : source->size(); }
};

/// Returns the response to a malformed request.
[[nodiscard]] Response response_to(const RequestError& error);

/// Appends everything before the body. The body follows unless the request was HEAD, which has the same
/// Content-Length. Responses 101, 204 and 304 have neither a body nor Content-Length. `date`: now.
void append_head(std::string& output, const Response& response, bool keep_alive,
                 std::chrono::sys_seconds date);

}  // namespace talus::server::http
