#include "web/site_answer.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "web/documents.h"
#include "web/entity_tag.h"

namespace talus::server::web {
namespace {

constexpr std::string_view kForever = "public, max-age=31536000, immutable";

// No inline code and no foreign sources. The viewer makes blobs itself, and may show another server's world
// by WebSocket.
constexpr std::string_view kPolicy =
    "default-src 'self'; script-src 'self'{}; connect-src 'self' ws: wss:; "
    "img-src 'self' blob: data:; worker-src 'self' blob:; style-src 'self'; frame-ancestors 'none'; "
    "base-uri 'none'";

/// A site without WebAssembly gets no permission to compile it.
void guard(http::Response& response, const Site& site) {
  response.fields.push_back(
      {"Content-Security-Policy", fmt::format(kPolicy, site.has_wasm() ? " 'wasm-unsafe-eval'" : "")});
  response.fields.push_back({"X-Content-Type-Options", "nosniff"});
  response.fields.push_back({"Referrer-Policy", "no-referrer"});
}

/// Relative, as a proxy may serve the site under a path prefix.
std::string way_to_root(std::string_view path) {
  std::string way{"./"};
  for (auto slashes = std::count(path.begin(), path.end(), '/'); slashes > 1; --slashes) way += "../";
  return way;
}

http::Response nothing_there(std::string_view path, const Site& site) {
  http::Response response{
      404, "text/html; charset=utf-8",
      fmt::format("<!doctype html>\n<html lang=\"en\">\n<title>Not found</title>\n"
                  "<h1>Nothing is here</h1>\n<p>The viewer is <a href=\"{}\">here</a>.</p>\n",
                  way_to_root(path))};
  guard(response, site);
  return response;
}

}  // namespace

http::Response site_answer(const Site* site, const http::Request& request) {
  const std::string_view path = request.path();
  if (site == nullptr) {
    return error_response(
        404, wire::ErrorCode::malformed,
        "here are /v1/world, /v1/heights, /v1/stream and chunks; the viewer is not served: talusd "
        "serves it with --web");
  }
  const Site::File* const file = site->find(path);
  if (file == nullptr) return nothing_there(path, *site);
  const Site::Form& form = file->form_for(request.list("Accept-Encoding"));
  http::Response response{200, file->content_type};
  response.cache_control = file->hashed ? kForever : http::kNoCache;
  response.etag = form.etag;
  if (file->forms.size() > 1) response.fields.push_back({"Vary", "Accept-Encoding"});
  if (lists_tag(request.list("If-None-Match"), form.etag)) {
    response.status = 304;
    return response;
  }
  if (!form.encoding.empty()) response.fields.push_back({"Content-Encoding", std::string{form.encoding}});
  response.kept = form.bytes;
  guard(response, *site);
  return response;
}

}  // namespace talus::server::web
