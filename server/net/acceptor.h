// A listening socket, and the loop that accepts its connections whatever goes wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>
#include <tl/expected.hpp>

#include <talus/protocol/endpoint.h>
#include "net/handler_memory.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"

namespace talus::server {

class Acceptor {
 public:
  /// The context on which the next socket is to be served.
  using NextContext = std::function<asio::io_context&()>;
  using OnSocket = std::function<void(asio::ip::tcp::socket)>;
  /// Closes a connection, whose descriptor the next one takes; false where there is none to close.
  using MakeRoom = std::function<bool()>;

  /// Accepts on `io`, which one thread runs. `clock` outlives it.
  Acceptor(asio::io_context& io, Logger log, const Clock& clock);

  /// Opens the listening socket; returns its address with the real port, or why not.
  [[nodiscard]] tl::expected<std::string, std::string> listen(const protocol::Endpoint& wanted);

  /// Hands each socket to `on_socket`, on the io_context's thread until close(); once, after listen(). A
  /// connection that its peer has reset already is one too, or none. An accept that fails, as without
  /// descriptors or memory, is tried again, at once where `make_room` made room. What any of them throws is
  /// logged.
  void start(
      NextContext next_context, OnSocket on_socket, MakeRoom make_room = [] { return false; });

  /// On the io_context's thread.
  void close();

 private:
  // No coroutine: the frames of Asio's awaitables need memory. One of these operations is in flight at a
  // time, in memory_.
  struct Step;
  void wait_for_connection();
  void on_readable(std::error_code failed);
  void pause();
  void end_pause(std::error_code);

  /// Accepts a connection where waiting for it has not failed. False where the next is better tried later.
  [[nodiscard]] bool accept_one(std::error_code failed) noexcept;
  void hand_over(asio::ip::tcp::socket socket) noexcept;
  void log_failure(std::string_view why) noexcept;

  asio::io_context& io_;
  asio::ip::tcp::acceptor socket_;
  asio::steady_timer pause_;
  Logger log_;
  const Clock& clock_;
  HandlerAllocator<std::byte> memory_{std::make_shared<HandlerMemory>()};
  NextContext next_context_;
  OnSocket on_socket_;
  MakeRoom make_room_;
  Clock::time_point last_line_ = Clock::time_point::min();
  std::uint64_t unlogged_ = 0;  // accepts that failed since
  Clock::time_point first_unlogged_{};
};

}  // namespace talus::server
