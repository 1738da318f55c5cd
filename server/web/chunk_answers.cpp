#include "web/chunk_answers.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "web/column_fetch.h"
#include "web/columns_body.h"

namespace talus::server::web {
namespace {

/// Redirects to the newest revision. Must not be cached: a newer one may follow soon.
template <typename ChunksRoute>
http::Response moved_to(const ChunksRoute& route, std::uint64_t newest) {
  return {307, kBytes, {}, {{"Location", last_part_of(route, newest)}}};
}

template <typename ChunksRoute>
Answer check_path(const Exchange& exchange, const ChunksRoute& route) {
  if (auto wrong = check_world(exchange.context(), route.fingerprint, route.codec)) return wrong;
  return route.edition ? check_store(exchange.context(), route.edition->store) : std::nullopt;
}

template <typename ChunksRoute>
Version version_of(const ChunksRoute& route) {
  return route.edition ? Version::edited : Version::generated;
}

/// From west to east, then from north to south.
ChunkKey column_of(const ColumnsRoute& route, std::int32_t number) {
  ChunkKey column = route.corner;
  column.coord.x += number % route.edge;
  column.coord.z += number / route.edge;
  return column;
}

/// Maximum revision of the route's columns.
std::uint64_t newest_of(const Exchange& exchange, const ColumnsRoute& route) {
  std::uint64_t newest = 0;
  for (std::int32_t i = 0; i < route.edge * route.edge; ++i) {
    newest = std::max(newest, exchange.context().edits->column_revision(column_of(route, i)));
  }
  return newest;
}

/// Returns true if a request for `asked` is answered with the current state: if `asked` is the newest
/// revision, or was recently. A client that is always redirected to the next revision would never finish
/// while the land is being edited. Land without recent edits has one path, under which caches keep it.
bool is_given_newest(const Exchange& exchange, std::uint64_t asked, std::uint64_t newest) {
  if (asked >= newest) return asked == newest;
  const WebContext& context = exchange.context();
  return context.recent_revisions.has(asked, context.edits->revision(), exchange.began());
}

http::Response answer_with(Exchange& exchange, const ChunkRoute& route, const EncodedChunkPtr& chunk) {
  http::Response response = exchange.immutable(chunk);
  if (route.edition && chunk->revision() != route.edition->revision) {
    exchange.tell_revision(response, chunk->revision());
  }
  exchange.charge(1, response);
  return response;
}

}  // namespace

Answer answer_now(Exchange& exchange, const ChunkRoute& route) {
  if (auto wrong = check_path(exchange, route)) return wrong;
  if (route.edition) {
    const std::uint64_t newest = exchange.chunks().revision(route.key);
    if (!is_given_newest(exchange, route.edition->revision, newest)) return moved_to(route, newest);
  }
  const EncodedChunkPtr chunk = exchange.chunks().find(route.key, version_of(route));
  if (chunk == nullptr) return std::nullopt;
  if (exchange.requester().next_chunk(exchange.began()) > exchange.began()) return std::nullopt;
  exchange.found_in_memory();
  return answer_with(exchange, route, chunk);
}

asio::awaitable<http::Response> answer_later(Exchange& exchange, const ChunkRoute& route) {
  if (auto wrong = co_await exchange.requester().wait_for_rates(exchange.executor())) {
    co_return *std::move(wrong);
  }
  const SessionContext& shared = exchange.shared();
  const std::vector<ChunkKey> keys(1, route.key);
  auto chunks = co_await exchange.start_fetch().get(keys, version_of(route), exchange.deadline());
  if (!chunks) co_return fetch_failed(chunks.error(), shared.memory);
  shared.metrics.cold_latency.add(shared.clock.now() - exchange.began());
  co_return answer_with(exchange, route, chunks->front());
}

Answer answer_now(Exchange& exchange, const ColumnsRoute& route) {
  if (auto wrong = check_path(exchange, route)) return wrong;
  if (!route.edition) return std::nullopt;
  const std::uint64_t newest = newest_of(exchange, route);
  if (is_given_newest(exchange, route.edition->revision, newest)) return std::nullopt;
  return moved_to(route, newest);
}

asio::awaitable<http::Response> answer_later(Exchange& exchange, const ColumnsRoute& route) {
  if (!exchange.takes_work(0)) co_return no_memory();
  Requester& requester = exchange.requester();
  if (auto wrong = co_await requester.wait_for_rates(exchange.executor())) co_return *std::move(wrong);
  const std::uint64_t before = route.edition ? newest_of(exchange, route) : kBaseRevision;
  ColumnFetch columns{exchange, version_of(route)};
  std::string body;
  if (route.square) append_square_head(body, route.edge);
  for (std::int32_t i = 0; i < route.edge * route.edge; ++i) {
    const ChunkKey column = column_of(route, i);
    std::string one;
    Answer wrong = co_await columns.append(column, one, 2 * body.size());
    if (!wrong) {
      if (route.square) append_length(body, static_cast<std::uint32_t>(one.size()));
      body += one;
      exchange.hold(2 * body.size());
      if (body.size() > kMaxBodyBytes) wrong = body_too_large();
    }
    if (wrong) {
      requester.charge(columns.chunks(), 0);  // they were generated
      co_return *std::move(wrong);
    }
  }
  http::Response response = exchange.immutable(std::move(body));
  if (route.edition) {
    // Edits made while the columns were fetched may be in only some of them. Edits made before are in all of
    // them.
    const std::uint64_t newest = std::max(newest_of(exchange, route), columns.revision());
    if (before != newest || newest != route.edition->revision) exchange.tell_revision(response, before);
  }
  exchange.charge(columns.chunks(), response);
  co_return response;
}

}  // namespace talus::server::web
