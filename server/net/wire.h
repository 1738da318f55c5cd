// A connection's bytes: over TCP as they are, or over TLS. An AsyncReadStream and AsyncWriteStream of Asio.
//
// Which of the two is decided at each call, and plain bytes go straight to the socket. One read and one write
// may be under way at a time, on the socket's executor.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include <asio/buffer.hpp>
#include <asio/compose.hpp>
#include <asio/error.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>

#include <talus/tls/session.h>

namespace talus::server {

class Wire {
 public:
  using executor_type = asio::ip::tcp::socket::executor_type;

  explicit Wire(asio::ip::tcp::socket socket) : socket_{std::move(socket)} {}

  [[nodiscard]] executor_type get_executor() { return socket_.get_executor(); }
  [[nodiscard]] asio::ip::tcp::socket& socket() { return socket_; }

  [[nodiscard]] bool by_tls() const { return tls_.has_value(); }
  /// From here on by TLS; async_handshake() comes first.
  void use_tls(const tls::Context& context) {
    socket_.native_non_blocking(true);
    tls_.emplace(context, tls::Role::server, socket_.native_handle());
  }

  template <typename Token>
  auto async_handshake(Token&& token) {
    return compose([](tls::Session& session) { return session.handshake(); }, std::forward<Token>(token));
  }

  template <typename Buffers, typename Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    if (!tls_) return socket_.async_read_some(buffers, std::forward<Token>(token));
    const asio::mutable_buffer into{*asio::buffer_sequence_begin(buffers)};
    return compose(
        [into](tls::Session& session) {
          return session.read({static_cast<std::byte*>(into.data()), into.size()});
        },
        std::forward<Token>(token));
  }

  template <typename Buffers, typename Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    if (!tls_) return socket_.async_write_some(buffers, std::forward<Token>(token));
    const asio::const_buffer from{*asio::buffer_sequence_begin(buffers)};
    return compose(
        [from](tls::Session& session) {
          return session.write({static_cast<const std::byte*>(from.data()), from.size()});
        },
        std::forward<Token>(token));
  }

  /// By TLS alone: the last word. shutdown() comes then.
  template <typename Token>
  auto async_say_end(Token&& token) {
    return compose([](tls::Session& session) { return session.close_notify(); }, std::forward<Token>(token));
  }

  /// How often a write by TLS had to wait until the kernel took more.
  [[nodiscard]] std::size_t write_waits() const { return write_waits_; }

  /// Nothing more is written.
  void shutdown() {
    std::error_code ignored;
    socket_.shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
  }
  /// What is under way ends with an error.
  void close() {
    std::error_code ignored;
    if (tls_ && socket_.is_open()) (void)tls_->close_notify();  // if it still goes: nobody waits for it
    socket_.close(ignored);
  }

 private:
  /// A step of TLS, again and again until it is done, waiting for the socket between.
  template <typename Step>
  struct Operation {
    Wire& wire;
    Step step;
    tls::Step last{};
    bool waited = false;
    bool posted = false;

    template <typename Self>
    void operator()(Self& self, std::error_code failed = {}) {
      using Result = tls::Step::Result;
      // Two waits can end in one look at the socket, and the first may close it: its number may be another's.
      if (!wire.socket_.is_open()) failed = asio::error::operation_aborted;
      if (!posted) last = failed ? tls::Step{Result::failed, failed} : step(*wire.tls_);
      if (last.waits()) {
        waited = true;
        if (last.result == Result::wait_to_write) ++wire.write_waits_;
        const auto ready = last.result == Result::wait_to_read ? asio::ip::tcp::socket::wait_read
                                                               : asio::ip::tcp::socket::wait_write;
        wire.socket_.async_wait(ready, std::move(self));
      } else if (!waited && !std::exchange(posted, true)) {
        asio::post(wire.socket_.get_executor(), std::move(self));  // never from inside the call
      } else {
        self.complete(last.result == Result::closed ? asio::error::eof : last.error, last.bytes);
      }
    }
  };

  template <typename Step, typename Token>
  auto compose(Step step, Token&& token) {
    return asio::async_compose<Token, void(std::error_code, std::size_t)>(
        Operation<Step>{*this, std::move(step)}, token, socket_);
  }

  asio::ip::tcp::socket socket_;
  std::optional<tls::Session> tls_;
  std::size_t write_waits_ = 0;
};

}  // namespace talus::server
