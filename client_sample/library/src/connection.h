// One connection, plain or TLS, optionally inside a WebSocket: frames in, bytes out, and the reason for its
// end.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include <asio/awaitable.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>

#include <talus/client/client.h>
#include <talus/client/clock.h>
#include <talus/client/error.h>
#include <talus/client/options.h>
#include <talus/protocol/frame.h>
#include <talus/websocket/client_side.h>

#include "servers.h"
#include "tls_stream.h"

namespace talus::client {

/// Owned by a shared_ptr that every coroutine using it holds; its operations end soon after close().
class Connection {
 public:
  /// `clock` must outlive this object.
  Connection(const asio::any_io_executor& executor, Clock& clock, std::uint32_t frame_limit_bytes);

  [[nodiscard]] asio::awaitable<Result<void>> open(const std::string& host, const std::string& port,
                                                   const TlsOptions& tls, const WebSocketOptions& websocket,
                                                   Servers& servers);

  /// Reads the next complete frame, valid until the next call.
  [[nodiscard]] asio::awaitable<Result<std::span<const std::byte>>> next_frame(Stats& stats);

  /// `bytes` may be empty while must_write().
  [[nodiscard]] asio::awaitable<Result<void>> write(std::span<const std::byte> bytes);
  /// True if the WebSocket layer must send a control frame; wait_for_work() was woken for it.
  [[nodiscard]] bool must_write() const { return websocket_ && websocket_->has_control(); }

  /// Ends the connection; pending operations fail with `reason`. Only the first reason counts.
  void close(ClientError reason);

  /// Calls close(reason) unless the deadline is moved or cancelled first.
  void set_deadline(const std::shared_ptr<Connection>& self, std::chrono::milliseconds after,
                    ClientError reason);
  void lift_deadline();

  [[nodiscard]] bool is_closed() const { return reason_.has_value(); }

  /// For the writer: waits until there may be something to write. wake() ends the wait.
  [[nodiscard]] asio::awaitable<void> wait_for_work();
  void wake();

  /// Returns after `time`, or earlier if the connection ends.
  [[nodiscard]] asio::awaitable<void> pause(std::chrono::milliseconds time);

  [[nodiscard]] Clock::Time last_received() const { return last_received_; }

 private:
  [[nodiscard]] asio::awaitable<Result<void>> shake_hands(const std::string& host, const TlsOptions& options);
  [[nodiscard]] asio::awaitable<Result<void>> upgrade(const std::string& host, const std::string& port,
                                                      const WebSocketOptions& options);
  /// Removes the WebSocket framing, if any, and returns the protocol's bytes.
  [[nodiscard]] std::span<const std::byte> unwrap(std::span<std::byte> bytes);
  [[nodiscard]] asio::awaitable<TransferResult> read_some();
  [[nodiscard]] asio::awaitable<TransferResult> write_all(std::span<const std::byte> bytes);
  [[nodiscard]] ClientError reason_or(ErrorKind kind, std::string message) const;

  asio::ip::tcp::resolver resolver_;
  asio::ip::tcp::socket socket_;
  std::unique_ptr<TlsStream> tls_;  // null: no TLS
  std::optional<websocket::ClientSide> websocket_;
  std::vector<std::byte> wrapped_;  // in flight
  std::string where_;               // HOST:PORT
  bool received_any_ = false;       // a byte from the server
  Clock& clock_;
  std::unique_ptr<Timer> deadline_;
  std::unique_ptr<Timer> pause_;
  asio::steady_timer work_;  // a signal: never expires
  protocol::FrameReader reader_;
  std::optional<ClientError> reason_;
  Clock::Time last_received_{};
  std::array<std::byte, std::size_t{64} * 1024> buffer_{};
  std::span<const std::byte> unread_;
};

}  // namespace talus::client
