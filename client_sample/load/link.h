// One connection on one thread: frames in, frames out. An idle connection has no buffer: all connections of a
// thread read into a shared one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>

#include <talus/protocol/frame.h>
#include <talus/protocol/message.h>

#include <talus/client/tls.h>
#include <talus/client/websocket.h>
#include <talus/tls/session.h>

namespace talus::load {

/// Called by its Link; may call the Link back, even close().
class LinkOwner {
 public:
  virtual ~LinkOwner() = default;
  virtual void opened() = 0;
  virtual void received(const wire::Message& message, std::size_t frame_bytes) = 0;
  /// Everything from one read was delivered.
  virtual void read_done() = 0;
  /// The connection ended other than by close(). `broken`: because of bytes that are not a message.
  virtual void ended(const std::string& reason, bool broken) = 0;
};

class Link {
 public:
  /// `io`, `scratch` and `owner` must outlive the Link.
  Link(asio::io_context& io, std::span<std::byte> scratch, LinkOwner& owner);

  struct OpenOptions {
    asio::ip::tcp::endpoint server;
    std::optional<asio::ip::address> from;
    bool paced = false;  // only take() reads bytes, and the kernel is asked to buffer few
    tls::Context tls{};  // null: no TLS
    client::TlsOptions tls_options{};
    client::WebSocketOptions websocket{};
  };
  void open(const OpenOptions& options);
  void send(std::span<const std::byte> frame);
  /// Reads at most `max_bytes` available bytes. No effect before opened(): earlier bytes belong to the
  /// handshake.
  void take(std::size_t max_bytes);
  /// `abruptly`: with a reset, like a connection that is cut.
  void close(bool abruptly);

  [[nodiscard]] std::uint64_t received_bytes() const { return received_bytes_; }

 private:
  void shake_hands();
  void secured();
  void upgrade();
  void established();
  void send_bytes(std::span<const std::byte> bytes);
  void send_control();
  void await_input();
  void await_output();
  void feed(std::span<const std::byte> bytes);
  void fail(const std::string& reason, bool broken = false);

  [[nodiscard]] std::size_t read_some(std::span<std::byte> into, std::error_code& error);
  [[nodiscard]] std::size_t write_some(std::span<const std::byte> from, std::error_code& error);

  asio::ip::tcp::socket socket_;
  std::optional<tls::Session> tls_;
  std::optional<websocket::ClientSide> websocket_;
  bool paced_ = false;
  bool established_ = false;
  std::span<std::byte> scratch_;
  LinkOwner& owner_;
  protocol::FrameReader frames_;
  std::vector<std::byte> unsent_;
  bool writing_ = false;
  std::uint64_t received_bytes_ = 0;
  std::uint32_t opening_ = 0;  // distinguishes callbacks of an earlier connection
};

}  // namespace talus::load
