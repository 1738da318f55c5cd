// Upgrades an HTTP request to a WebSocket. Pure functions. Source: RFC 6455, section 4.2.
#pragma once

#include "net/http/request.h"
#include "net/http/response.h"

namespace talus::server::websocket {

/// Returns status 101, or the error of the request. The caller checks the origin.
[[nodiscard]] http::Response answer_handshake(const http::Request& request);

}  // namespace talus::server::websocket
