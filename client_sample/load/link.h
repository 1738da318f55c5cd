// One connection: frames in, frames out, on one thread. An idle one holds no buffer of its own: bytes are
// read into a scratch that all connections of a thread share.
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

/// Called by its Link; may call it back, close() included.
class LinkOwner {
 public:
  virtual ~LinkOwner() = default;
  virtual void opened() = 0;
  virtual void received(const wire::Message& message, std::size_t frame_bytes) = 0;
  /// Everything of one read was received.
  virtual void read_done() = 0;
  /// The connection is gone, and not by close(). `broken`: by bytes that are no message.
  virtual void ended(const std::string& reason, bool broken) = 0;
};

class Link {
 public:
  /// All three outlive it.
  Link(asio::io_context& io, std::span<std::byte> scratch, LinkOwner& owner);

  struct Opening {
    asio::ip::tcp::endpoint server;
    std::optional<asio::ip::address> from;
    bool paced = false;  // bytes are read by take() alone, and the kernel is asked to keep few
    tls::Context tls{};  // null: plain
    client::TlsOptions tls_options{};
    client::WebSocketOptions websocket{};
  };
  void open(const Opening& opening);
  void send(std::span<const std::byte> frame);
  /// Reads `most` bytes at most, of those that are there. Nothing before opened(): what comes until then is
  /// the handshake's.
  void take(std::size_t most);
  /// `abruptly`: by a reset, as a connection that is cut.
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
  std::uint32_t opening_ = 0;  // so that what belongs to a connection before is told apart
};

}  // namespace talus::load
