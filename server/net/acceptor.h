// A listening socket, and the loop that accepts its connections whatever goes wrong.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <asio/awaitable.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>
#include <tl/expected.hpp>

#include <talus/protocol/endpoint.h>
#include "log/logger.h"

namespace talus::server {

/// File descriptors held so that there are some when the process has no more. One thread's.
class DescriptorReserve {
 public:
  explicit DescriptorReserve(std::size_t wanted) : wanted_{wanted} { fill(); }
  ~DescriptorReserve();
  DescriptorReserve(const DescriptorReserve&) = delete;
  DescriptorReserve& operator=(const DescriptorReserve&) = delete;

  /// Opens what is missing, as far as the system allows.
  void fill();
  /// Gives one to who asks the system next; false where none is left.
  [[nodiscard]] bool release_one();

 private:
  std::size_t wanted_;
  std::vector<int> held_;
};

class Acceptor {
 public:
  /// The context on which the next socket is to be served.
  using NextContext = std::function<asio::io_context&()>;
  using OnSocket = std::function<void(asio::ip::tcp::socket)>;

  /// Accepts on `io`, which one thread runs. `reserved_descriptors`: for connections that are accepted
  /// although the process has no descriptor left.
  Acceptor(asio::io_context& io, Logger log, std::size_t reserved_descriptors = 0);

  /// Opens the listening socket; returns its address with the real port, or why not.
  [[nodiscard]] tl::expected<std::string, std::string> listen(const protocol::Endpoint& wanted);

  /// Hands each socket to `on_socket` until close(). A connection that its peer has reset already is one too,
  /// or none; an accept that fails, as without descriptors, is tried again; what `on_socket` throws is
  /// logged.
  [[nodiscard]] asio::awaitable<void> run(NextContext next_context, OnSocket on_socket);

  /// On the io_context's thread.
  void close();

 private:
  asio::ip::tcp::acceptor socket_;
  asio::steady_timer pause_;
  Logger log_;
  DescriptorReserve reserve_;
};

}  // namespace talus::server
