// Cache-Control, ETag and CORS fields of answers. Source: RFC 9110, 8.8.3 and 13.1.2; RFC 9111, 5.2; the
// Fetch standard, "CORS protocol".
#pragma once

#include <string_view>

#include "config/allowed_origins.h"
#include "net/http/request.h"
#include "net/http/response.h"

namespace talus::server::web {

/// The receivers of an answer.
struct Audience {
  bool anybody = false;  // available without a token
  bool caches = false;   // may be stored by every cache
};

/// Cache-Control of content that never changes.
[[nodiscard]] std::string_view immutable_for(const Audience& audience);
/// Cache-Control of an answer that is valid now, but has another path of its own for ever.
[[nodiscard]] std::string_view passing_for(const Audience& audience);
/// Cache-Control of content that may change.
[[nodiscard]] std::string_view fresh_for(const Audience& audience);
/// Cache-Control of content that may change and has the audience of chunks.
[[nodiscard]] std::string_view revalidated_for(const Audience& audience);

/// Adds an ETag (by default, of the body) and turns the response into a 304 if the client already has it.
void tag(const http::Request& request, http::Response& response);
void tag(const http::Request& request, http::Response& response, const http::EntityTag& etag);

/// Returns true if the request comes from a page of an origin that is not allowed.
[[nodiscard]] bool is_strange_page(const http::Request& request, const AllowedOrigins& origins);
/// Sets the CORS fields, and returns false if the request's page may not read the response. A response to an
/// origin that is not listed must not be cached.
bool add_origin_fields(const http::Request& request, const Audience& audience, const AllowedOrigins& origins,
                       http::Response& response);

}  // namespace talus::server::web
