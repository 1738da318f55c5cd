// The operators' HTTP server, on a thread of its own: whatever players do, it answers. Nothing of it is for
// players or for the open network.
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
  /// Open at once. Where descriptors run out it is fewer: the next takes the quietest one's.
  static constexpr std::size_t kMaxConnections = 32;

  /// `clock` outlives it.
  AdminServer(const Clock& clock, Logger log);
  /// Ends the thread.
  ~AdminServer();
  AdminServer(const AdminServer&) = delete;
  AdminServer& operator=(const AdminServer&) = delete;

  /// Opens the listening socket; returns its address with the real port, or why not.
  [[nodiscard]] tl::expected<std::string, std::string> listen(const protocol::Endpoint& wanted);
  /// Starts the thread, on which `answers` are asked; after listen(). Called again, others are asked from
  /// then on.
  void start(OperatorAnswers answers);
  /// Ends the thread; connections stay as they are until the destructor.
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
