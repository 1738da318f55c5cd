#include "net/server.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <asio/co_spawn.hpp>
#include <asio/post.hpp>
#include <asio/redirect_error.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/vectors/instruction_set.h>

#include "app/session_settings.h"
#include "generation/terrain_generator.h"
#include "metrics/exposition.h"
#include "net/descriptors.h"
#include "session/retry_after.h"

namespace talus::server {
namespace {

using asio::ip::tcp;
using std::chrono::milliseconds;

constexpr milliseconds kAcceptPause{100};  // when the system has no descriptor left
constexpr milliseconds kWatchInterval{50};
constexpr const char* kGoingAway = "the server is ending";

std::size_t io_threads(const Config& config) {
  if (config.threads.io != 0) return config.threads.io;
  return std::max(1U, std::thread::hardware_concurrency());
}

std::size_t generator_threads(const Config& config) {
  if (config.threads.generator != 0) return config.threads.generator;
  return std::max(1U, std::thread::hardware_concurrency());
}

WorldInfo describe_world(const terrain::World& world, ContentHash store_id) {
  return {world.fingerprint(),        store_id,
          world.materials(),          terrain::height_range(world),
          terrain::find_spawn(world), "talusd " TALUS_VERSION};
}

/// In eroded land heights cost a region for each tile, with a halo of two columns a step and a pass over it
/// for every step: what one request may ask for stays within about a second.
Config fitted_to(Config config, const terrain::World& world) {
  constexpr std::uint64_t kColumnSteps = 100'000'000;
  if (world.spec().method == terrain::Method::erosion) {
    const auto side = static_cast<std::uint64_t>(kChunkSize + 2 * world.halo());
    const std::uint64_t tile = side * side * static_cast<std::uint64_t>(world.spec().erosion_steps);
    config.limits.height_tiles_per_request = std::max<std::uint64_t>(1, kColumnSteps / tile);
  }
  return config;
}

ServiceSettings service_settings(const Config& config) {
  return {generator_threads(config), static_cast<int>(config.generation.patch_tiles),
          config.generation.queue_chunks, config.cache.chunk_bytes, config.cache.patch_bytes};
}

tcp::endpoint resolved(const Endpoint& endpoint, asio::io_context& io, std::error_code& error) {
  tcp::resolver resolver{io};
  const auto found = resolver.resolve(endpoint.host, std::to_string(endpoint.port),
                                      tcp::resolver::passive | tcp::resolver::numeric_service, error);
  return error ? tcp::endpoint{} : found.begin()->endpoint();
}

std::string to_text(const tcp::endpoint& endpoint) {
  return to_string(Endpoint{endpoint.address().to_string(), endpoint.port()});
}

}  // namespace

Server::Server(const Config& config, std::shared_ptr<const terrain::World> world, AccessControl& access,
               std::optional<TlsIdentity> tls, Logger log)
    : config_{fitted_to(config, *world)},
      log_{std::move(log)},
      log_of_clients_{for_clients(log_)},
      access_{access},
      terrain_{std::move(world)},
      session_limits_{session_limits(config_.limits)},
      rates_{rate_limits(config.rates)},
      admission_{config.limits.connections, config.limits.connections_per_address,
                 milliseconds{static_cast<milliseconds::rep>(config.rates.burst_ms)}},
      memory_{config.limits.memory_bytes},
      tls_{std::move(tls)},
      door_{config_,
            admission_,
            metrics_,
            log_of_clients_,
            [this] { return memory_.takes_connections(); },
            [this](Guest guest) { welcome(std::move(guest)); }},
      io_{io_threads(config), log_},
      chunks_{std::make_unique<TerrainGenerator>(terrain_, static_cast<int>(config.generation.patch_tiles)),
              service_settings(config), log_, metrics_, memory_},
      acceptor_{io_.control()},
      signals_{io_.control(), SIGTERM, SIGINT},
      hangups_{io_.control(), SIGHUP},
      drain_timer_{io_.control()},
      accept_pause_{io_.control()},
      watch_timer_{io_.control()} {}

tl::expected<std::string, std::string> Server::listen() {
  const auto failed = [&](const std::error_code& error) {
    return tl::make_unexpected(fmt::format("listen {}: {}; choose another address with --listen HOST:PORT",
                                           to_string(config_.listen), error.message()));
  };
  std::error_code error;
  const tcp::endpoint wanted = resolved(config_.listen, io_.control(), error);
  if (error) return failed(error);
  acceptor_.open(wanted.protocol(), error);
  if (!error) acceptor_.set_option(tcp::acceptor::reuse_address{true}, error);
  if (!error) acceptor_.bind(wanted, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  if (error) return failed(error);
  return to_text(acceptor_.local_endpoint());
}

tl::expected<std::string, std::string> Server::listen_to_operators() {
  if (!config_.admin) return std::string{};
  const auto failed = [&](const std::string& what) {
    return tl::make_unexpected(fmt::format("admin {}: {}; choose another address with --admin HOST:PORT",
                                           to_string(*config_.admin), what));
  };
  std::error_code error;
  const tcp::endpoint wanted = resolved(*config_.admin, io_.control(), error);
  if (error) return failed(error.message());
  auto opened = AdminServer::open(io_.control(), wanted,
                                  {[this] { return metrics_text(); }, [this] { return !draining_; }});
  if (!opened) return failed(opened.error());
  admin_.emplace(*std::move(opened));
  return to_text(admin_->address());
}

std::string Server::metrics_text() {
  const ChunkService::Status status = chunks_.status();
  Depths depths{status.jobs, status.clients, status.chunk_cache_bytes, status.patch_cache_bytes, draining_};
  for (std::size_t use = 0; use < kMemoryUses.size(); ++use) {
    depths.memory_bytes[use] = memory_.used(static_cast<MemoryUse>(use));
  }
  depths.memory_limit_bytes = memory_.limit_bytes();
  depths.certificate_expires = tls_ ? tls_->expires : 0;
  return prometheus_text(metrics_, depths, read_process(),
                         {TALUS_VERSION, terrain::kGeneratorVersion, to_string(terrain_->fingerprint()),
                          std::string{to_string(instruction_set())}});
}

void Server::run() {
  // Who has not yet shown a PROXY header has no place among the connections, and a socket all the same.
  const std::uint64_t wanted = descriptors_needed(config_.limits.connections, io_threads(config_)) +
                               (config_.proxies.empty() ? 0 : config_.limits.handshakes_under_way);
  if (const std::uint64_t allowed = set_descriptor_limit(wanted); allowed < wanted) {
    log_->warn(
        "the system allows {} open files, fewer than the {} that limits.connections {} needs; raise ulimit "
        "-n",
        allowed, wanted, config_.limits.connections);
  }
  world_.emplace(describe_world(*terrain_, store_id_));
  chunks_.start();
  // Without either the server would not be one.
  std::exception_ptr failure;
  const auto end = [&](const std::exception_ptr& thrown) {
    if (!thrown) return;
    failure = thrown;
    io_.stop();
  };
  asio::co_spawn(io_.control(), accept(), end);
  asio::co_spawn(io_.control(), obey_signals(), end);
  keep_watch();
  asio::co_spawn(io_.control(), obey_hangups(), end);
  io_.run();
  leave_signals();
  door_.tell_refusals({});
  if (failure) std::rethrow_exception(failure);
}

// Nobody obeys any more, and caches take their time to go: by default a signal would now kill what ends well.
void Server::leave_signals() {
  sigset_t ours;
  sigset_t before;
  sigemptyset(&ours);
  for (const int signal : {SIGHUP, SIGTERM, SIGINT}) sigaddset(&ours, signal);
  ::pthread_sigmask(SIG_BLOCK, &ours, &before);  // asio puts the default back first; generators take none
  std::error_code ignored;
  hangups_.clear(ignored);
  signals_.clear(ignored);
  std::signal(SIGHUP, SIG_IGN);
  for (const int signal : {SIGTERM, SIGINT}) {
    std::signal(signal, [](int) { std::_Exit(0); });  // as a second one does while clients are told
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

asio::awaitable<void> Server::accept() {
  while (acceptor_.is_open()) {
    std::error_code failed;
    tcp::socket socket =
        co_await acceptor_.async_accept(io_.next(), asio::redirect_error(asio::use_awaitable, failed));
    if (!acceptor_.is_open()) co_return;
    if (!failed) {
      const ConnectionId id = ++last_id_;
      try {
        door_.knock(std::move(socket), id, tls_ ? tls_->context : nullptr);
      } catch (const std::exception& error) {
        log_->error("conn {}: failed: {}", id, error.what());
      }
    } else if (failed != asio::error::connection_aborted) {
      log_->warn("cannot accept a connection: {}", failed.message());
      accept_pause_.expires_after(kAcceptPause);
      co_await accept_pause_.async_wait(asio::redirect_error(asio::use_awaitable, failed));
    }
  }
}

void Server::welcome(Guest guest) {
  const ConnectionId id = guest.id;
  log_->debug("conn {} {}: opened", id, guest.address);
  const ConnectionContext context{
      {session_limits_, *world_, source_, memory_, metrics_, access_, rates_, clock_},
      config_.limits,
      registry_,
      log_of_clients_};
  try {
    const auto connection = std::make_shared<Connection>(std::move(guest), context);
    registry_.add(id, connection);
    connection->start();
    // drain() may have looked before it stood there.
    if (draining_) connection->go_away(kGoingAway, retry_after::kShutdown);
  } catch (...) {
    registry_.remove(id);
    throw;
  }
}

asio::awaitable<void> Server::obey_hangups() {
  for (;;) {
    co_await hangups_.async_wait(asio::use_awaitable);
    const bool has_keys = config_.access.wanted();
    if (!has_keys && !tls_) log_->info("SIGHUP: nothing to read again: no keys and no certificate are set");
    if (has_keys) renew_keys();
    if (tls_) renew_identity();
  }
}

void Server::renew_keys() {
  if (const auto renewed = access_.reload()) {
    log_->info("SIGHUP: {}", *renewed);
  } else {
    log_->error("SIGHUP: {}", renewed.error());
  }
}

void Server::renew_identity() {
  auto renewed = load_tls(config_.tls.certificate, config_.tls.key);
  if (renewed) {
    tls_ = *std::move(renewed);
    log_->info("SIGHUP: TLS with {} from now on", tls_->description);
  } else {
    log_->error("SIGHUP: {}; new connections still get the old one: {}", renewed.error(), tls_->description);
  }
}

void Server::keep_watch() {
  chunks_.fit_caches();
  source_.tell_of_room();
  door_.tell_refusals();
  watch_timer_.expires_after(kWatchInterval);
  watch_timer_.async_wait([this](std::error_code cancelled) {
    if (!cancelled) keep_watch();
  });
}

asio::awaitable<void> Server::obey_signals() {
  const int first = co_await signals_.async_wait(asio::use_awaitable);
  log_->info("{}: no new connections; {} are told to go away", first == SIGINT ? "SIGINT" : "SIGTERM",
             admission_.connections());
  drain();
  co_await signals_.async_wait(asio::use_awaitable);
  log_->warn("a second signal: ending at once");
  io_.stop();
}

void Server::drain() {
  draining_ = true;
  std::error_code ignored;
  acceptor_.close(ignored);
  for (const auto& connection : registry_.all()) connection->go_away(kGoingAway, retry_after::kShutdown);
  registry_.when_empty([this] { asio::post(io_.control(), [this] { io_.stop(); }); });
  drain_timer_.expires_after(milliseconds{static_cast<milliseconds::rep>(config_.shutdown.drain_ms)});
  drain_timer_.async_wait([this](std::error_code cancelled) {
    if (cancelled) return;
    log_->warn("{} connections were still open after {} ms", admission_.connections(),
               config_.shutdown.drain_ms);
    io_.stop();
  });
}

}  // namespace talus::server
