// A listening socket, and the loop that accepts its connections whatever goes wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <system_error>
#include <vector>

#include <asio/awaitable.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>
#include <tl/expected.hpp>

#include <talus/protocol/endpoint.h>
#include "clock/clock.h"
#include "log/logger.h"

namespace talus::server {

/// File descriptors held so that there are some when the process has no more. One thread's.
class DescriptorReserve {
 public:
  explicit DescriptorReserve(std::size_t wanted);
  ~DescriptorReserve();
  DescriptorReserve(const DescriptorReserve&) = delete;
  DescriptorReserve& operator=(const DescriptorReserve&) = delete;

  /// Opens what is missing, as far as the system allows.
  void fill() noexcept;
  /// Gives one to who asks the system next; false where none is left.
  [[nodiscard]] bool release_one();

 private:
  std::size_t wanted_;
  std::vector<int> held_;  // of capacity wanted_
};

class Acceptor {
 public:
  /// The context on which the next socket is to be served.
  using NextContext = std::function<asio::io_context&()>;
  using OnSocket = std::function<void(asio::ip::tcp::socket)>;
  /// Closes a connection, whose descriptor the next one takes; false where there is none to close.
  using MakeRoom = std::function<bool()>;

  /// Accepts on `io`, which one thread runs. `reserved_descriptors`: for connections that are accepted
  /// although the process has no descriptor left. `clock` outlives it.
  Acceptor(asio::io_context& io, Logger log, const Clock& clock, std::size_t reserved_descriptors = 0);

  /// Opens the listening socket; returns its address with the real port, or why not.
  [[nodiscard]] tl::expected<std::string, std::string> listen(const protocol::Endpoint& wanted);

  /// Hands each socket to `on_socket` until close(). A connection that its peer has reset already is one too,
  /// or none; an accept that fails, as without descriptors, is tried again, at once where `make_room` made
  /// room; what any of them throws is logged.
  [[nodiscard]] asio::awaitable<void> run(
      NextContext next_context, OnSocket on_socket, MakeRoom make_room = [] { return false; });

  /// On the io_context's thread.
  void close();

 private:
  /// One connection, or why there is none.
  [[nodiscard]] asio::awaitable<std::error_code> accept_one(const NextContext& next_context,
                                                            const OnSocket& on_socket);
  [[nodiscard]] asio::awaitable<void> pause();
  void log_failure(const std::string& why);

  asio::ip::tcp::acceptor socket_;
  asio::steady_timer pause_;
  Logger log_;
  const Clock& clock_;
  DescriptorReserve reserve_;
  Clock::time_point last_line_ = Clock::time_point::min();
  std::uint64_t unlogged_ = 0;  // accepts that failed since
};

}  // namespace talus::server
