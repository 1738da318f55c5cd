#include "web/web_connection.h"

#include <exception>
#include <memory>
#include <type_traits>
#include <utility>
#include <variant>

#include <asio/post.hpp>

#include "net/http/connection.h"
#include "net/runner_context.h"
#include "net/session_stream.h"
#include "net/websocket/stream.h"
#include "web/player_handler.h"

namespace talus::server::web {
namespace {

/// The registry's peer for an HTTP connection.
template <Stream S>
class WebPeer final : public Peer, public std::enable_shared_from_this<WebPeer<S>> {
 public:
  WebPeer(asio::any_io_executor executor, std::shared_ptr<PlayerHandler> handler)
      : executor_{std::move(executor)}, handler_{std::move(handler)} {}

  /// Call before any other function.
  void set_connection(const std::shared_ptr<http::Connection<S>>& connection) { connection_ = connection; }

  [[nodiscard]] std::optional<Clock::time_point> session_since() const override { return std::nullopt; }
  void go_away(const std::string&, std::chrono::milliseconds) override {
    with_connection([](http::Connection<S>& connection, PlayerHandler&) { connection.finish(); });
  }
  void access_changed() override {
    with_connection([](http::Connection<S>& connection, PlayerHandler& handler) {
      if (handler.requester().blocked()) connection.close();
    });
  }
  void rates_changed() override {
    with_connection(
        [](http::Connection<S>&, PlayerHandler& handler) { handler.requester().rates_changed(); });
  }

 private:
  template <typename Call>
  void with_connection(Call call) {
    asio::post(executor_, [call, self = this->shared_from_this()] {
      const auto connection = self->connection_.lock();
      if (connection != nullptr && connection->open()) call(*connection, *self->handler_);
    });
  }

  const asio::any_io_executor executor_;
  const std::shared_ptr<PlayerHandler> handler_;
  std::weak_ptr<http::Connection<S>> connection_;
};

template <Stream S>
void become_session(S stream, std::span<const std::byte> unread, PlayerHandler& handler,
                    const WebContext& context) {
  using WebSocket = websocket::WebSocketStream<S>;
  const RunnerContextPtr& runner_context = context.runner;
  runner_context->session.metrics.web_open.fall();
  ConnectionInfo info = handler.requester().session_info();
  info.accepted = runner_context->session.clock.now();  // the time-out for Hello begins here
  start_session(std::make_unique<SessionStreamOf<WebSocket>>(WebSocket{std::move(stream), unread}),
                std::move(info), handler.requester().take_slot(), runner_context);
}

template <Stream S>
void start(S stream, const ConnectionInfo& info, Admission::Slot slot, const WebContextPtr& context) {
  Metrics& metrics = context->runner->session.metrics;
  Registry& registry = context->runner->registry;
  const asio::any_io_executor executor = stream.get_executor();
  const auto handler = std::make_shared<PlayerHandler>(context, info, std::move(slot), executor);
  handler->on_closed([&metrics, &registry, id = info.id] {
    registry.remove(id);
    metrics.web_open.fall();
  });
  const auto peer = std::make_shared<WebPeer<S>>(executor, handler);
  // The peer lives as long as the connection.
  const auto take_over = [peer, handler, context](S taken, std::span<const std::byte> unread) {
    become_session(std::move(taken), unread, *handler, *context);
  };
  const auto connection =
      std::make_shared<http::Connection<S>>(std::move(stream), context->service, handler, take_over);
  peer->set_connection(connection);
  handler->share([weak = std::weak_ptr{connection}, executor] {
    asio::post(executor, [weak] {
      if (const auto alive = weak.lock()) alive->close();
    });
  });
  metrics.web_open.rise();
  try {
    registry.add(info.id, peer);
    asio::post(executor, [connection, handler] {
      // Changes made before it was registered.
      if (handler->requester().blocked()) return connection->close();
      handler->requester().rates_changed();
      connection->start();
    });
  } catch (...) {
    registry.remove(info.id);
    metrics.web_open.fall();
    throw;
  }
}

}  // namespace

void start_connection(AcceptedConnection accepted, const WebContextPtr& context) {
  std::visit(
      [&](auto& stream) { start(std::move(stream), accepted.info, std::move(accepted.slot), context); },
      accepted.stream);
}

}  // namespace talus::server::web
