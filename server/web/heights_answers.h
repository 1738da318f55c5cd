// Answers for heights over HTTP. Source: PROTOCOL.md, "HTTP".
#pragma once

#include <asio/awaitable.hpp>

#include "net/http/response.h"
#include "web/error_answers.h"
#include "web/exchange.h"
#include "web/routes.h"

namespace talus::server::web {

/// Returns only errors.
[[nodiscard]] Answer answer_now(Exchange& exchange, const HeightsRoute& route);
[[nodiscard]] asio::awaitable<http::Response> answer_later(Exchange& exchange, const HeightsRoute& route);

}  // namespace talus::server::web
