// Answers for chunks and columns of chunks over HTTP. Source: PROTOCOL.md, "HTTP".
#pragma once

#include <asio/awaitable.hpp>

#include "net/http/response.h"
#include "web/error_answers.h"
#include "web/exchange.h"
#include "web/routes.h"

namespace talus::server::web {

/// Returns a chunk in memory; nullopt if answer_later() must get it.
[[nodiscard]] Answer answer_now(Exchange& exchange, const ChunkRoute& route);
[[nodiscard]] asio::awaitable<http::Response> answer_later(Exchange& exchange, const ChunkRoute& route);

/// Returns only errors and redirects.
[[nodiscard]] Answer answer_now(Exchange& exchange, const ColumnsRoute& route);
[[nodiscard]] asio::awaitable<http::Response> answer_later(Exchange& exchange, const ColumnsRoute& route);

}  // namespace talus::server::web
