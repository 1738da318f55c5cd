#include "connection.h"

#include <utility>

#include <asio/connect.hpp>
#include <asio/experimental/as_tuple.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>

#include <talus/client/websocket.h>

#include "wait_until.h"

namespace talus::client {
namespace {

// Operations return errors as values: a tuple that begins with the error code.
constexpr auto kAsTuple = asio::experimental::as_tuple(asio::use_awaitable);

/// True if the rejected frame begins with "HTTP", as every answer of an HTTP server does.
bool is_http(const protocol::FrameError& error) {
  return error.claimed_bytes == 0x50545448U + protocol::kPrefixBytes;
}

}  // namespace

Connection::Connection(const asio::any_io_executor& executor, Clock& clock, std::uint32_t frame_limit_bytes)
    : resolver_{executor},
      socket_{executor},
      clock_{clock},
      deadline_{clock.make_timer(executor)},
      pause_{clock.make_timer(executor)},
      work_{executor},
      reader_{frame_limit_bytes} {}

ClientError Connection::reason_or(ErrorKind kind, std::string message) const {
  return reason_ ? *reason_ : ClientError{kind, std::move(message), {}};
}

asio::awaitable<Result<void>> Connection::open(const std::string& host, const std::string& port,
                                               const TlsOptions& tls, const WebSocketOptions& websocket,
                                               Servers& servers) {
  where_ = host + ":" + port;
  const auto [resolve_error, endpoints] = co_await resolver_.async_resolve(host, port, kAsTuple);
  if (resolve_error || is_closed()) {
    co_return tl::unexpected{
        reason_or(ErrorKind::unreachable, where_ + ": no such host or port: " + resolve_error.message())};
  }
  const auto addresses = servers.in_order(endpoints);
  const auto [connect_error, endpoint] = co_await asio::async_connect(socket_, addresses, kAsTuple);
  if (connect_error || is_closed()) {
    co_return tl::unexpected{
        reason_or(ErrorKind::unreachable, where_ + ": no server answers there: " + connect_error.message())};
  }
  servers.reached(endpoint);
  std::error_code ignored;  // without this option a connection is slower, but works
  socket_.set_option(asio::ip::tcp::no_delay{true}, ignored);
  last_received_ = clock_.now();
  Result<void> done;
  if (tls.on) done = co_await shake_hands(host, tls);
  if (done && websocket.on) done = co_await upgrade(host, port, websocket);
  if (!done && !is_closed()) done.error().message = where_ + ": " + done.error().message;
  co_return done;
}

asio::awaitable<Result<void>> Connection::shake_hands(const std::string& host, const TlsOptions& options) {
  auto stream = make_tls_stream(socket_, options, host);
  if (!stream) co_return tl::unexpected{stream.error()};
  tls_ = std::move(*stream);
  auto shaken = co_await tls_->handshake();
  if (is_closed()) co_return tl::unexpected{*reason_};
  co_return shaken;
}

asio::awaitable<Result<void>> Connection::upgrade(const std::string& host, const std::string& port,
                                                  const WebSocketOptions& options) {
  auto side = new_websocket(options, host, port);
  if (!side) co_return tl::unexpected{side.error()};
  websocket_ = std::move(*side);
  const std::string request = websocket_->request();
  std::error_code error;
  std::tie(error, std::ignore) = co_await write_all(std::as_bytes(std::span{request}));
  while (!error && !websocket_->is_open() && !websocket_->failure()) {
    std::size_t count = 0;
    std::tie(error, count) = co_await read_some();
    unread_ = unwrap(std::span{buffer_}.first(count));
  }
  if (is_closed()) co_return tl::unexpected{*reason_};
  if (websocket_->failure() && !websocket_->is_open()) {
    co_return tl::unexpected{error_of(*websocket_->failure())};
  }
  if (error) {
    co_return tl::unexpected{ClientError{
        ErrorKind::disconnected,
        "the server ended the connection in the WebSocket handshake (" + error.message() +
            "); a WebSocket needs talusd's HTTP address (--http), and TLS if that address uses it",
        {}}};
  }
  received_any_ = true;
  last_received_ = clock_.now();
  co_return Result<void>{};
}

std::span<const std::byte> Connection::unwrap(std::span<std::byte> bytes) {
  if (!websocket_) return bytes;
  const std::size_t payload = websocket_->take(bytes);
  if (websocket_->has_control()) wake();
  return bytes.first(payload);
}

// Not inlined into the coroutines: g++ 12 destroys the result of a conditional operator in a co_await twice.
asio::awaitable<TransferResult> Connection::read_some() {
  if (tls_) return tls_->read_some(asio::buffer(buffer_));
  return socket_.async_read_some(asio::buffer(buffer_), kAsTuple);
}

asio::awaitable<TransferResult> Connection::write_all(std::span<const std::byte> bytes) {
  const auto buffer = asio::buffer(bytes.data(), bytes.size());
  if (tls_) return tls_->write_all(buffer);
  return asio::async_write(socket_, buffer, kAsTuple);
}

asio::awaitable<Result<std::span<const std::byte>>> Connection::next_frame(Stats& stats) {
  if (reader_.has_frame()) reader_.pop();
  while (true) {
    if (is_closed()) co_return tl::unexpected{*reason_};
    const auto taken = reader_.feed(unread_);
    if (!taken && is_http(taken.error()) && !websocket_) {
      co_return tl::unexpected{
          ClientError{ErrorKind::broken_protocol,
                      where_ + ": an HTTP server answers there; talusd's is reached by WebSocket: " +
                          (tls_ ? "wss://" : "ws://") + where_,
                      {}}};
    }
    if (!taken) {
      co_return tl::unexpected{ClientError{
          ErrorKind::broken_protocol, "the server broke the protocol: " + taken.error().message(), {}}};
    }
    unread_ = unread_.subspan(*taken);
    if (reader_.has_frame()) co_return reader_.frame();
    if (websocket_ && websocket_->failure()) {
      co_return tl::unexpected{is_closed() ? *reason_ : error_of(*websocket_->failure())};
    }

    const auto [error, count] = co_await read_some();
    if (error && !received_any_ && !tls_) {
      co_return tl::unexpected{reason_or(ErrorKind::disconnected,
                                         where_ + ": the server ended the connection without an answer (" +
                                             error.message() +
                                             "); if it wants TLS, connect by TLS (--tls); a proxy without a "
                                             "ready server ends connections in the same way")};
    }
    if (error) {
      co_return tl::unexpected{reason_or(ErrorKind::disconnected,
                                         reader_.mid_frame() ? "the connection ended in the middle of a frame"
                                                             : "the connection ended: " + error.message())};
    }
    received_any_ = true;
    stats.received_bytes += count;
    last_received_ = clock_.now();
    unread_ = unwrap(std::span{buffer_}.first(count));
  }
}

asio::awaitable<Result<void>> Connection::write(std::span<const std::byte> bytes) {
  if (websocket_) {
    wrapped_.clear();
    while (websocket_->has_control()) websocket_->append_control(wrapped_, random_mask());
    if (!bytes.empty()) websocket::ClientSide::append(wrapped_, bytes, random_mask());
    bytes = wrapped_;
  }
  const auto [error, count] = co_await write_all(bytes);
  if (error) {
    co_return tl::unexpected{reason_or(ErrorKind::disconnected, "the connection ended: " + error.message())};
  }
  co_return Result<void>{};
}

void Connection::close(ClientError reason) {
  if (!reason_) reason_ = std::move(reason);
  std::error_code ignored;  // the connection is over in any case
  socket_.close(ignored);
  resolver_.cancel();
  deadline_->cancel();
  work_.cancel();
  pause_->cancel();
}

void Connection::set_deadline(const std::shared_ptr<Connection>& self, std::chrono::milliseconds after,
                              ClientError reason) {
  deadline_->async_wait_until(clock_.now() + after,
                              [self, reason = std::move(reason)](std::error_code error) {
                                if (!error) self->close(reason);
                              });
}

void Connection::lift_deadline() {
  deadline_->cancel();
}

asio::awaitable<void> Connection::wait_for_work() {
  if (is_closed()) co_return;
  work_.expires_at(std::chrono::steady_clock::time_point::max());
  co_await work_.async_wait(kAsTuple);
}

void Connection::wake() {
  work_.cancel();
}

asio::awaitable<void> Connection::pause(std::chrono::milliseconds time) {
  if (is_closed()) co_return;
  co_await wait_until(*pause_, clock_.now() + time);
}

}  // namespace talus::client
