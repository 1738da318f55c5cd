// Answers requests outside /v1. Pure functions. Source: OPERATIONS.md, "The viewer".
#pragma once

#include "net/http/request.h"
#include "net/http/response.h"
#include "web/site.h"

namespace talus::server::web {

/// Returns the site's file in a form that the client accepts; 304 if the client already has it; a page that
/// links to the viewer if there is no such file. `site` null: an error in JSON that lists what this server
/// offers. The response refers to the site's bytes.
[[nodiscard]] http::Response site_answer(const Site* site, const http::Request& request);

}  // namespace talus::server::web
