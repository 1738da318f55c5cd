// Chunks and columns of them by HTTP. Source: PROTOCOL.md, "HTTP".
#pragma once

#include <asio/awaitable.hpp>

#include "net/http/response.h"
#include "web/error_answers.h"
#include "web/exchange.h"
#include "web/routes.h"

namespace talus::server::web {

/// A chunk in memory; none: answer_later() has it.
[[nodiscard]] Answer answer_now(Exchange& exchange, const ChunkRoute& route);
[[nodiscard]] asio::awaitable<http::Response> answer_later(Exchange& exchange, const ChunkRoute& route);

/// Only what is wrong.
[[nodiscard]] Answer answer_now(Exchange& exchange, const ColumnsRoute& route);
[[nodiscard]] asio::awaitable<http::Response> answer_later(Exchange& exchange, const ColumnsRoute& route);

}  // namespace talus::server::web
