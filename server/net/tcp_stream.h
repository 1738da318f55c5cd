// A Stream over TCP: bytes without framing.
#pragma once

#include <poll.h>

#include <chrono>
#include <cstddef>
#include <utility>

#include <asio/awaitable.hpp>
#include <asio/buffer.hpp>
#include <asio/ip/tcp.hpp>

namespace talus::server {

class TcpStream {
 public:
  using executor_type = asio::ip::tcp::socket::executor_type;
  static constexpr bool kWritesWhole = true;
  // Each additional piece costs the system as much as copying about 2 KiB from distant memory. With fewer
  // than 64 pieces the largest batch is written in one call.
  static constexpr std::size_t kGatherFrom = 2560;

  explicit TcpStream(asio::ip::tcp::socket socket) : socket_{std::move(socket)} {}

  [[nodiscard]] executor_type get_executor() { return socket_.get_executor(); }
  [[nodiscard]] asio::ip::tcp::socket& socket() { return socket_; }

  /// Sends small writes at once, and lets the kernel hold few unsent bytes: newer output cannot overtake
  /// them.
  void prefer_latency();

  /// The connection is reset if the peer's system answers nothing for this time, also while nothing is sent.
  void give_up_after(std::chrono::milliseconds silence);

  template <typename Buffers, typename Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    return socket_.async_read_some(buffers, std::forward<Token>(token));
  }
  template <typename Buffers, typename Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    return socket_.async_write_some(buffers, std::forward<Token>(token));
  }

  /// Does not wait. Returns the number of bytes the kernel took; also 0 on an error, which async_write_some
  /// reports.
  [[nodiscard]] std::size_t write_now(asio::const_buffer from);

  /// Returns true if the peer will send nothing more, even if unread bytes remain before its end.
  [[nodiscard]] bool peer_hung_up() { return peer_has(POLLRDHUP); }
  [[nodiscard]] bool peer_reset() { return peer_has(0); }
  [[nodiscard]] std::size_t unread() {
    std::error_code ignored;
    return socket_.available(ignored);
  }

  [[nodiscard]] asio::awaitable<void> say_end() { co_return; }
  void shutdown() {
    std::error_code ignored;
    socket_.shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
  }
  void close() {
    std::error_code ignored;
    socket_.close(ignored);
  }
  [[nodiscard]] std::size_t write_waits() const { return 0; }

 private:
  /// Returns true after `events` of poll(2) or an error.
  [[nodiscard]] bool peer_has(short events);

  asio::ip::tcp::socket socket_;
};

}  // namespace talus::server
