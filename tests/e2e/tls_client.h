// A client by TLS that speaks frames, and blocks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <talus/protocol/frame.h>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/ssl.hpp>

#include "raw_client.h"

namespace talus::e2e {

/// A client's first bytes of TLS.
[[nodiscard]] std::string client_hello();

class TlsClient {
 public:
  /// Connects to 127.0.0.1, sends `before` as it is, and shakes hands.
  explicit TlsClient(std::uint16_t port, const std::string& before = "", int version = TLS1_3_VERSION);

  /// Of the handshake.
  [[nodiscard]] const std::error_code& failure() const { return failure_; }
  /// Of the server's certificate.
  [[nodiscard]] long serial();

  void send(const protocol::Frame& frame);
  /// The next frame; none where the server has said that it ends.
  [[nodiscard]] std::optional<ReceivedFrame> receive();
  /// As receive(), and it must be one of this kind.
  template <typename Table>
  [[nodiscard]] ReceivedFrame expect_kind() {
    auto received = receive();
    if (!received) throw std::runtime_error{"the server ended the connection"};
    (void)received->template as<Table>();
    return *std::move(received);
  }
  /// How the server ended TLS: asio::error::eof where it said so.
  [[nodiscard]] const std::error_code& ended() const { return ended_; }
  /// Closes with a RST.
  void reset();
  /// Waits until the server has closed the socket, answering nothing.
  void await_close();

 private:
  asio::io_context io_;
  asio::ip::tcp::socket socket_{io_};
  asio::ssl::context context_{asio::ssl::context::tls_client};
  asio::ssl::stream<asio::ip::tcp::socket&> stream_{socket_, context_};
  protocol::FrameReader frames_{protocol::kMaxFrameBytes};
  std::string unread_;
  std::error_code failure_;
  std::error_code ended_;
};

}  // namespace talus::e2e
