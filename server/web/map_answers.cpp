#include "web/map_answers.h"

#include <cstddef>
#include <utility>

namespace talus::server::web {
namespace {

http::Response picture_response(Exchange& exchange, const PicturePtr& picture) {
  exchange.keep(picture);
  http::Response response{200, "image/png"};
  response.cache_control = immutable_for(exchange.audience);
  response.kept = picture->png;
  tag(exchange.request(), response);
  return response;
}

}  // namespace

Answer answer_now(Exchange& exchange, const MapRoute& route) {
  if (auto wrong = check_world(exchange.context(), route.fingerprint)) return wrong;
  const PicturePtr picture = exchange.chunks().find_map(route.tile);
  if (picture == nullptr) return std::nullopt;
  if (exchange.requester().next_chunk(exchange.began()) > exchange.began()) return std::nullopt;
  exchange.requester().charge(1, 0);
  return picture_response(exchange, picture);
}

// A tile that must be drawn is charged as the columns of chunks that it shows at its level. They are charged
// before it is drawn, even if the client does not wait for it.
asio::awaitable<http::Response> answer_later(Exchange& exchange, const MapRoute& route) {
  constexpr std::size_t kColumnsShown =
      std::size_t{map::kTilePixels / kChunkSize} * (map::kTilePixels / kChunkSize);
  const SessionContext& shared = exchange.shared();
  Requester& requester = exchange.requester();
  PicturePtr picture = exchange.chunks().find_map(route.tile);
  if (picture == nullptr && !exchange.takes_work(0)) co_return no_memory();
  if (auto wrong = co_await requester.wait_for_rates(exchange.executor())) co_return *std::move(wrong);
  requester.charge(picture == nullptr ? kColumnsShown : 1, 0);
  if (picture == nullptr) {
    auto drawn = co_await exchange.start_fetch().map(route.tile, exchange.deadline());
    if (!drawn) co_return fetch_failed(drawn.error(), shared.memory);
    picture = *std::move(drawn);
  }
  co_return picture_response(exchange, picture);
}

}  // namespace talus::server::web
