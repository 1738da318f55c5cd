// How an HTTP request becomes a WebSocket. Pure. Source: RFC 6455, section 4.2.
#pragma once

#include "net/http/request.h"
#include "net/http/response.h"

namespace talus::server::websocket {

/// Status 101, or what is wrong with the request. Whether its origin may connect is the caller's to check.
[[nodiscard]] http::Response answer_handshake(const http::Request& request);

}  // namespace talus::server::websocket
