// What a request beside /v1 gets. Pure. Source: OPERATIONS.md, "The viewer".
#pragma once

#include "net/http/request.h"
#include "net/http/response.h"
#include "web/site.h"

namespace talus::server::web {

/// The site's file, as the client can take it; 304 where it has that; a page that says where the viewer is
/// where there is no such file. `site` null: what this server has instead, as JSON. The response's bytes are
/// the site's.
[[nodiscard]] http::Response site_answer(const Site* site, const http::Request& request);

}  // namespace talus::server::web
