// A listening socket and a loop that keeps accepting its connections after any failure.
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
  /// Returns the context that will serve the next socket.
  using NextContext = std::function<asio::io_context&()>;
  using OnSocket = std::function<void(asio::ip::tcp::socket)>;
  /// Closes a connection to free its descriptor for the next one; false if there is nothing to close.
  using MakeRoom = std::function<bool()>;

  /// Accepts on `io`, which one thread runs. `clock` outlives it.
  Acceptor(asio::io_context& io, Logger log, const Clock& clock);

  /// Opens the listening socket. Returns its address with the actual port, or the reason for failure.
  [[nodiscard]] tl::expected<std::string, std::string> listen(const protocol::Endpoint& wanted);

  /// Passes each socket to `on_socket` on the io_context's thread until close(). Call once, after listen(). A
  /// connection that its peer has already reset may be passed on or dropped. A failed accept (e.g. without
  /// descriptors or memory) is retried, at once if `make_room` closed a connection. Exceptions thrown by the
  /// callbacks are logged.
  void start(
      NextContext next_context, OnSocket on_socket, MakeRoom make_room = [] { return false; });

  /// Call on the io_context's thread.
  void close();

 private:
  // Not a coroutine: the frames of Asio's awaitables need memory. One of these operations is in flight at a
  // time; its memory is memory_.
  struct Step;
  void wait_for_connection();
  void on_readable(std::error_code failed);
  void pause();
  void end_pause(std::error_code);

  /// Accepts a connection unless waiting for it failed. Returns false if the next accept should be delayed.
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
  std::uint64_t unlogged_ = 0;  // failed accepts since the last log line
  Clock::time_point first_unlogged_{};
};

}  // namespace talus::server
