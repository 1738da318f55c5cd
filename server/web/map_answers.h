// Answers for tiles of the map over HTTP. Source: PROTOCOL.md, "HTTP".
#pragma once

#include <asio/awaitable.hpp>

#include "net/http/response.h"
#include "web/error_answers.h"
#include "web/exchange.h"
#include "web/routes.h"

namespace talus::server::web {

/// Returns a tile in memory; nullopt if answer_later() must get it.
[[nodiscard]] Answer answer_now(Exchange& exchange, const MapRoute& route);
[[nodiscard]] asio::awaitable<http::Response> answer_later(Exchange& exchange, const MapRoute& route);

}  // namespace talus::server::web
