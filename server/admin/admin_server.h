// The operators' HTTP server, on its own thread, so that it answers whatever the load. Not for players or the
// open network.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <thread>

#include <asio/io_context.hpp>
#include <tl/expected.hpp>

#include <talus/protocol/endpoint.h>
#include "admin/operators_page.h"
#include "net/acceptor.h"
#include "net/http/connections.h"
#include "net/tcp_stream.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"

namespace talus::server {

class AdminServer {
 public:
  /// Maximum open connections. If descriptors run out the maximum is lower. At the maximum a new connection
  /// closes the longest idle one of the address with most.
  static constexpr std::size_t kMaxConnections = 32;

  /// `clock` must outlive this.
  AdminServer(const Clock& clock, Logger log);
  /// Stops the thread.
  ~AdminServer();
  AdminServer(const AdminServer&) = delete;
  AdminServer& operator=(const AdminServer&) = delete;

  /// Opens the listening socket and returns its address with the real port. An error is one line.
  [[nodiscard]] tl::expected<std::string, std::string> listen(const protocol::Endpoint& wanted);
  /// Starts the thread that calls `answers`; requires listen(). Calling it again replaces the answers.
  void start(OperatorAnswers answers);
  /// Stops the thread; connections stay open until the destructor.
  void stop();

 private:
  void run();
  void on_connection(asio::ip::tcp::socket socket);

  Logger log_;
  asio::io_context io_{1};
  Acceptor acceptor_;
  http::Service service_;
  http::Connections<TcpStream> connections_;
  std::shared_ptr<const OperatorAnswers> answers_;
  std::thread thread_;
};

}  // namespace talus::server
