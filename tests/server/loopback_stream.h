// A Stream in memory whose other end the test holds: it says how many bytes a read gives and a write takes,
// and when either fails (after Seastar's loopback_socket). One thread's; no operation waits for the system.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/awaitable.hpp>
#include <asio/buffer.hpp>
#include <asio/compose.hpp>
#include <asio/error.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>

#include "net/stream.h"

namespace talus::server {

/// The test's end.
class Loopback {
 public:
  explicit Loopback(asio::io_context& io) : executor_{io.get_executor()}, readable_{io}, writable_{io} {}

  // ---- the script; changed() after a change while the server waits
  std::size_t read_bytes = SIZE_MAX;   // of one read at most
  std::size_t write_bytes = SIZE_MAX;  // of one write at most
  std::size_t room = SIZE_MAX;         // bytes that are taken before writes wait
  std::error_code read_error;
  std::error_code write_error;
  bool ended = false;  // the client sends no more

  void send(std::span<const std::byte> bytes) {
    to_server_.insert(to_server_.end(), bytes.begin(), bytes.end());
    changed();
  }
  void send(std::string_view text) { send(std::as_bytes(std::span{text})); }
  void end() {
    ended = true;
    changed();
  }
  void changed() {
    readable_.cancel();
    writable_.cancel();
  }

  // ---- what the server did
  std::vector<std::byte> received;
  std::size_t writes = 0;
  bool said_end = false;
  bool shut = false;
  bool closed = false;
  bool hung_up = false;  // says the system, whatever waits to be read
  bool reset = false;    // by the client, says the system
  bool gone = false;     // its system resets the connection when it is sent something

  [[nodiscard]] std::string_view text() const {
    return {reinterpret_cast<const char*>(received.data()), received.size()};
  }

 private:
  friend class LoopbackStream;
  asio::any_io_executor executor_;
  asio::steady_timer readable_;
  asio::steady_timer writable_;
  std::deque<std::byte> to_server_;
  std::size_t write_waits_ = 0;
};

class LoopbackStream {
 public:
  using executor_type = asio::any_io_executor;
  static constexpr bool kWritesWhole = true;
  static constexpr std::size_t kGatherFrom = 2560;

  explicit LoopbackStream(std::shared_ptr<Loopback> loopback) : loopback_{std::move(loopback)} {}

  [[nodiscard]] executor_type get_executor() { return loopback_->executor_; }

  template <typename Buffers, typename Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    const asio::mutable_buffer into{*asio::buffer_sequence_begin(buffers)};
    return compose(
        loopback_->readable_, [loopback = loopback_.get(), into] { return read(*loopback, into); },
        std::forward<Token>(token));
  }
  template <typename Buffers, typename Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    std::vector<asio::const_buffer> from{asio::buffer_sequence_begin(buffers),
                                         asio::buffer_sequence_end(buffers)};
    return compose(
        loopback_->writable_,
        [loopback = loopback_.get(), from = std::move(from)] { return write(*loopback, from); },
        std::forward<Token>(token));
  }

  [[nodiscard]] bool peer_hung_up() const { return loopback_->hung_up; }
  [[nodiscard]] std::size_t unread() const { return loopback_->to_server_.size(); }
  [[nodiscard]] bool peer_reset() const { return loopback_->reset; }
  [[nodiscard]] asio::awaitable<void> say_end() {
    loopback_->said_end = true;
    co_return;
  }
  void shutdown() { loopback_->shut = true; }
  void close() {
    loopback_->closed = true;
    loopback_->changed();
  }
  [[nodiscard]] std::size_t write_waits() const { return loopback_->write_waits_; }

 protected:
  [[nodiscard]] std::size_t try_write(asio::const_buffer from) { return write(*loopback_, {from}).bytes; }

 private:
  struct Completion {
    bool done = false;
    std::error_code error{};
    std::size_t bytes = 0;
  };

  static Completion read(Loopback& loopback, asio::mutable_buffer into) {
    if (loopback.closed) return {true, asio::error::operation_aborted};
    if (loopback.read_error) return {true, loopback.read_error};
    const std::size_t bytes = std::min({into.size(), loopback.read_bytes, loopback.to_server_.size()});
    if (bytes == 0) return {loopback.ended, asio::error::eof};
    const auto end = loopback.to_server_.begin() + static_cast<std::ptrdiff_t>(bytes);
    std::copy(loopback.to_server_.begin(), end, static_cast<std::byte*>(into.data()));
    loopback.to_server_.erase(loopback.to_server_.begin(), end);
    return {true, {}, bytes};
  }

  static Completion write(Loopback& loopback, const std::vector<asio::const_buffer>& from) {
    if (loopback.closed) return {true, asio::error::operation_aborted};
    if (loopback.write_error) return {true, loopback.write_error};
    const std::size_t offered = asio::buffer_size(from);
    const std::size_t bytes = std::min({offered, loopback.write_bytes, loopback.room});
    if (bytes == 0 && offered > 0) {
      ++loopback.write_waits_;
      return {};
    }
    if (loopback.gone) {
      loopback.reset = true;
      loopback.read_error = loopback.write_error = asio::error::connection_reset;
      return {true, {}, bytes};
    }
    if (loopback.room != SIZE_MAX) loopback.room -= bytes;
    const std::size_t before = loopback.received.size();
    loopback.received.resize(before + bytes);
    asio::buffer_copy(asio::buffer(loopback.received.data() + before, bytes), from);
    ++loopback.writes;
    return {true, {}, bytes};
  }

  template <typename Step, typename Token>
  auto compose(asio::steady_timer& changed, Step step, Token&& token) {
    return asio::async_compose<Token, void(std::error_code, std::size_t)>(
        [loopback = loopback_, &changed, step = std::move(step), done = Completion{}, waited = false](
            auto& self, std::error_code = {}) mutable {
          if (done.done) return self.complete(done.error, done.bytes);
          done = step();
          if (done.done && waited) return self.complete(done.error, done.bytes);
          // As of a socket: what can be done is done at once, and told later.
          if (done.done) return asio::post(loopback->executor_, std::move(self));
          waited = true;
          changed.expires_at(asio::steady_timer::time_point::max());
          changed.async_wait(std::move(self));
        },
        token, loopback_->executor_);
  }

  std::shared_ptr<Loopback> loopback_;
};
static_assert(Stream<LoopbackStream>);

/// One that also takes at once what it has room for, as a TcpStream does.
class EagerLoopbackStream : public LoopbackStream {
 public:
  using LoopbackStream::LoopbackStream;

  [[nodiscard]] std::size_t write_now(asio::const_buffer from) { return try_write(from); }
};
static_assert(Stream<EagerLoopbackStream>);

}  // namespace talus::server
