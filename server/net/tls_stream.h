// A Stream over TLS on a TCP socket. OpenSSL reads and writes the socket directly: asio::ssl's buffers would
// cost 34 KiB per connection.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <asio/awaitable.hpp>
#include <asio/buffer.hpp>
#include <asio/compose.hpp>
#include <asio/error.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>
#include <asio/redirect_error.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/tls/session.h>

#include "net/tcp_stream.h"

namespace talus::server {

class TlsStream {
 public:
  using executor_type = TcpStream::executor_type;
  static constexpr bool kWritesWhole = false;  // one record at a time
  static constexpr std::size_t kGatherFrom = SIZE_MAX;

  /// Call handshake() first.
  TlsStream(TcpStream stream, const tls::Context& context)
      : stream_{std::move(stream)}, tls_{context, tls::Role::server, stream_.socket().native_handle()} {
    stream_.socket().native_non_blocking(true);
  }

  [[nodiscard]] executor_type get_executor() { return stream_.get_executor(); }
  [[nodiscard]] TcpStream& transport() { return stream_; }

  /// Before each step waits for the socket, then for `turn()`; ends with operation_aborted if that returns
  /// false.
  template <typename Turn>
  [[nodiscard]] asio::awaitable<std::error_code> handshake(Turn turn) {
    asio::ip::tcp::socket& socket = stream_.socket();
    auto wait_for = asio::ip::tcp::socket::wait_read;  // the client begins
    for (;;) {
      std::error_code failed;
      co_await socket.async_wait(wait_for, asio::redirect_error(asio::use_awaitable, failed));
      if (failed) co_return failed;
      if (!co_await turn()) co_return asio::error::operation_aborted;
      const tls::Step step = tls_.handshake();
      if (step.result == tls::Step::Result::closed) co_return asio::error::eof;
      if (!step.waits()) co_return step.error;
      if (step.result == tls::Step::Result::wait_to_write) ++write_waits_;
      wait_for = step.result == tls::Step::Result::wait_to_read ? asio::ip::tcp::socket::wait_read
                                                                : asio::ip::tcp::socket::wait_write;
    }
  }

  template <typename Buffers, typename Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    const asio::mutable_buffer into{*asio::buffer_sequence_begin(buffers)};
    return compose(
        [into](tls::Session& session) {
          return session.read({static_cast<std::byte*>(into.data()), into.size()});
        },
        std::forward<Token>(token));
  }

  template <typename Buffers, typename Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    const asio::const_buffer from{*asio::buffer_sequence_begin(buffers)};
    return compose(
        [from](tls::Session& session) {
          return session.write({static_cast<const std::byte*>(from.data()), from.size()});
        },
        std::forward<Token>(token));
  }

  [[nodiscard]] bool peer_hung_up() { return stream_.peer_hung_up(); }
  [[nodiscard]] std::size_t unread() { return stream_.unread(); }
  [[nodiscard]] bool peer_reset() { return stream_.peer_reset(); }

  [[nodiscard]] asio::awaitable<void> say_end();
  void shutdown() { stream_.shutdown(); }
  void close() {
    if (stream_.socket().is_open()) (void)tls_.close_notify();  // sent only if possible at once
    stream_.close();
  }
  [[nodiscard]] std::size_t write_waits() const { return write_waits_; }

 private:
  /// A step of TLS, repeated with waits for the socket until it is done.
  template <typename Step>
  struct Operation {
    TlsStream& stream;
    Step step;
    tls::Step last{};
    bool waited = false;
    bool posted = false;

    template <typename Self>
    void operator()(Self& self, std::error_code failed = {}) {
      using Result = tls::Step::Result;
      asio::ip::tcp::socket& socket = stream.stream_.socket();
      // Two waits can end in one poll of the socket, and the first may close it: its number may be in use
      // again.
      if (!socket.is_open()) failed = asio::error::operation_aborted;
      if (!posted) last = failed ? tls::Step{Result::failed, failed} : step(stream.tls_);
      if (last.waits()) {
        waited = true;
        if (last.result == Result::wait_to_write) ++stream.write_waits_;
        socket.async_wait(last.result == Result::wait_to_read ? asio::ip::tcp::socket::wait_read
                                                              : asio::ip::tcp::socket::wait_write,
                          std::move(self));
      } else if (!waited && !std::exchange(posted, true)) {
        asio::post(socket.get_executor(), std::move(self));  // never from within the call
      } else {
        self.complete(last.result == Result::closed ? asio::error::eof : last.error, last.bytes);
      }
    }
  };

  template <typename Step, typename Token>
  auto compose(Step step, Token&& token) {
    return asio::async_compose<Token, void(std::error_code, std::size_t)>(
        Operation<Step>{*this, std::move(step)}, token, stream_.socket());
  }

  TcpStream stream_;
  tls::Session tls_;
  std::size_t write_waits_ = 0;
};

}  // namespace talus::server
