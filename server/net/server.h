// talusd from its first listening socket to its last answer.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <asio/awaitable.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>
#include <tl/expected.hpp>

#include <talus/terrain/world.h>

#include "access/access_control.h"
#include "admin/admin_server.h"
#include "clock/clock.h"
#include "config/config.h"
#include "generation/chunk_service.h"
#include "log/logger.h"
#include "metrics/metrics.h"
#include "net/admission.h"
#include "net/chunk_service_source.h"
#include "net/connection.h"
#include "net/door.h"
#include "net/io_pool.h"
#include "net/registry.h"
#include "net/tls_context.h"
#include "session/world_info.h"

namespace talus::server {

class Server {
 public:
  /// `access` outlives it. `tls`: of config.tls; none where connections are plain. No thread is started
  /// before run().
  Server(const Config& config, std::shared_ptr<const terrain::World> world, AccessControl& access,
         std::optional<TlsIdentity> tls, Logger log);

  /// Opens the listening socket; returns the address with its real port, or one line.
  [[nodiscard]] tl::expected<std::string, std::string> listen();
  /// As listen(), for the operators' HTTP; an empty address where the config has none.
  [[nodiscard]] tl::expected<std::string, std::string> listen_to_operators();

  /// The store that clients are told of: before run().
  void keep_in(ContentHash store_id) { store_id_ = store_id; }

  /// Serves until SIGTERM or SIGINT, and then until every answer is sent or shutdown.drain_ms is over. SIGHUP
  /// reads certificates and keys again.
  void run();

 private:
  [[nodiscard]] std::string metrics_text();
  [[nodiscard]] asio::awaitable<void> accept();
  [[nodiscard]] asio::awaitable<void> obey_signals();
  /// Lets caches give way to everything else, and tells of refusals, all the time.
  void keep_watch();
  [[nodiscard]] asio::awaitable<void> obey_hangups();
  void renew_keys();
  void renew_identity();
  void leave_signals();
  void welcome(Guest guest);
  void drain();

  // In the order in which they may be taken down, last first: generator threads post to the contexts, and
  // connections in the contexts hold places and stand in the registry.
  Config config_;
  Logger log_;
  Logger log_of_clients_;
  AccessControl& access_;
  std::shared_ptr<const terrain::World> terrain_;
  ContentHash store_id_;
  std::optional<const WorldInfo> world_;  // from run() on
  SystemClock clock_;
  SessionLimits session_limits_;
  Metrics metrics_;
  RateLimits rates_;
  Admission admission_;
  Registry registry_;
  MemoryBudget memory_;  // connections give back to it
  std::optional<TlsIdentity> tls_;
  Door door_;
  IoPool io_;
  ChunkService chunks_;
  ChunkServiceSource source_{chunks_};

  asio::ip::tcp::acceptor acceptor_;
  asio::signal_set signals_;
  asio::signal_set hangups_;
  asio::steady_timer drain_timer_;
  asio::steady_timer accept_pause_;
  asio::steady_timer watch_timer_;
  std::optional<AdminServer> admin_;
  std::atomic<bool> draining_ = false;
  ConnectionId last_id_ = 0;
};

}  // namespace talus::server
