// Tiles of the map by HTTP. Source: PROTOCOL.md, "HTTP".
#pragma once

#include <asio/awaitable.hpp>

#include "net/http/response.h"
#include "web/error_answers.h"
#include "web/exchange.h"
#include "web/routes.h"

namespace talus::server::web {

/// A tile in memory; none: answer_later() has it.
[[nodiscard]] Answer answer_now(Exchange& exchange, const MapRoute& route);
[[nodiscard]] asio::awaitable<http::Response> answer_later(Exchange& exchange, const MapRoute& route);

}  // namespace talus::server::web
