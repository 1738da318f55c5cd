// Who may keep an answer, and which pages may read it. Source: RFC 9110, 8.8.3 and 13.1.2; RFC 9111, 5.2; the
// Fetch standard, "CORS protocol".
#pragma once

#include <string_view>

#include "config/allowed_origins.h"
#include "net/http/request.h"
#include "net/http/response.h"

namespace talus::server::web {

/// Who gets an answer.
struct Audience {
  bool anybody = false;  // nobody needs a token
  bool caches = false;   // every cache may keep it
};

/// Cache-Control of what never changes.
[[nodiscard]] std::string_view immutable_for(const Audience& audience);
/// Of what is right at this moment, and under another path for ever.
[[nodiscard]] std::string_view passing_for(const Audience& audience);
/// Of what may be another tomorrow.
[[nodiscard]] std::string_view fresh_for(const Audience& audience);
/// Likewise, where those get it who get chunks.
[[nodiscard]] std::string_view revalidated_for(const Audience& audience);

/// Gives it an ETag, of its body unless told, and makes it a 304 where the client has it.
void tag(const http::Request& request, http::Response& response);
void tag(const http::Request& request, http::Response& response, const http::EntityTag& etag);

/// Whether a page asks whose origin is none of these.
[[nodiscard]] bool is_strange_page(const http::Request& request, const AllowedOrigins& origins);
/// Which pages may read the response; it is kept by no cache where it is for one whose origin is not listed.
void add_origin_fields(const http::Request& request, const Audience& audience, const AllowedOrigins& origins,
                       http::Response& response);

}  // namespace talus::server::web
