#include "web/cache_fields.h"

#include <string>
#include <utility>

#include "web/entity_tag.h"

namespace talus::server::web {
namespace {

constexpr std::string_view kImmutable = "public, max-age=31536000, immutable";
constexpr std::string_view kPrivate = "private, no-store";

}  // namespace

std::string_view immutable_for(const Audience& audience) {
  return audience.caches ? kImmutable : kPrivate;
}

std::string_view passing_for(const Audience& audience) {
  return audience.caches ? http::kNoStore : kPrivate;
}

std::string_view fresh_for(const Audience& audience) {
  return audience.anybody ? http::kNoCache : kPrivate;
}

std::string_view revalidated_for(const Audience& audience) {
  return audience.caches ? http::kNoCache : kPrivate;
}

void tag(const http::Request& request, http::Response& response) {
  tag(request, response, entity_tag(response.content()));
}

void tag(const http::Request& request, http::Response& response, const http::EntityTag& etag) {
  response.etag = etag;
  if (!lists_tag(request.list("If-None-Match"), etag)) return;
  response.status = 304;
  response.body.clear();
  response.kept = {};
}

bool is_strange_page(const http::Request& request, const AllowedOrigins& origins) {
  return request.has("Origin") && !origins.allow(request.list("Origin"), request.list("Host"));
}

bool add_origin_fields(const http::Request& request, const Audience& audience, const AllowedOrigins& origins,
                       http::Response& response) {
  if (response.status == 101) return true;
  // A publicly cached answer is a single copy, which any page may read unless the operator restricts origins.
  if (origins.all() || (audience.caches && origins.unset())) {
    response.any_origin = true;
    return true;
  }
  bool strange = false;
  if (request.has("Origin")) {
    // All fields of this name, as a cache's key contains all of them.
    std::string origin = request.list("Origin");
    // A cache keeps one copy for each listed origin, and one for requests without an Origin. Any client can
    // invent other origins, together with a matching Host.
    if (!origins.lists(origin)) response.cache_control = passing_for(audience);
    strange = is_strange_page(request, origins);
    if (!strange) {
      response.fields.push_back({"Access-Control-Allow-Origin", std::move(origin)});
    }
  }
  response.fields.push_back({"Vary", "Origin"});  // a cache must not serve one origin's answer to another
  return !strange;
}

}  // namespace talus::server::web
