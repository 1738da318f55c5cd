#include "web/chunk_answers.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "web/column_fetch.h"
#include "web/columns_body.h"

namespace talus::server::web {
namespace {

http::Response chunk_response(const Exchange& exchange, const EncodedChunk& chunk) {
  const auto payload = chunk.payload();
  return exchange.immutable({reinterpret_cast<const char*>(payload.data()), payload.size()});
}

}  // namespace

Answer answer_now(Exchange& exchange, const ChunkRoute& route) {
  if (auto wrong = check_world(exchange.context(), route.fingerprint, route.codec)) return wrong;
  const SessionContext& shared = exchange.shared();
  const EncodedChunkPtr chunk = exchange.chunks().find(route.key);
  if (chunk == nullptr) return std::nullopt;
  if (exchange.requester().next_chunk(exchange.began()) > exchange.began()) return std::nullopt;
  shared.metrics.hot_latency.add(shared.clock.now() - exchange.began());
  return exchange.charged(1, chunk_response(exchange, *chunk));
}

asio::awaitable<http::Response> answer_later(Exchange& exchange, const ChunkRoute& route) {
  if (auto wrong = co_await exchange.requester().wait_for_rates(exchange.executor())) {
    co_return *std::move(wrong);
  }
  const SessionContext& shared = exchange.shared();
  const std::vector<ChunkKey> keys(1, route.key);
  auto chunks = co_await exchange.start_fetch().get(keys, exchange.deadline());
  if (!chunks) co_return fetch_failed(chunks.error(), shared.memory);
  shared.metrics.cold_latency.add(shared.clock.now() - exchange.began());
  const EncodedChunkPtr chunk = chunks->front();
  co_return exchange.charged(1, chunk_response(exchange, *chunk));
}

Answer answer_now(Exchange& exchange, const ColumnsRoute& route) {
  return check_world(exchange.context(), route.fingerprint, route.codec);
}

asio::awaitable<http::Response> answer_later(Exchange& exchange, const ColumnsRoute& route) {
  if (!exchange.shared().memory.takes_work()) co_return no_memory();
  Requester& requester = exchange.requester();
  if (auto wrong = co_await requester.wait_for_rates(exchange.executor())) co_return *std::move(wrong);
  ColumnFetch columns{exchange};
  std::string body;
  if (route.square) append_square_head(body, route.edge);
  for (std::int32_t i = 0; i < route.edge * route.edge; ++i) {
    ChunkKey column = route.corner;
    column.coord.x += i % route.edge;
    column.coord.z += i / route.edge;
    std::string one;
    Answer wrong = co_await columns.append(column, one, 2 * body.size());
    if (!wrong) {
      if (route.square) append_length(body, static_cast<std::uint32_t>(one.size()));
      body += one;
      exchange.hold(2 * body.size());
      if (body.size() > kMaxBodyBytes) wrong = body_too_large();
    }
    if (wrong) {
      requester.charge(columns.chunks(), 0);  // they were made
      co_return *std::move(wrong);
    }
  }
  co_return exchange.charged(columns.chunks(), exchange.immutable(std::move(body)));
}

}  // namespace talus::server::web
