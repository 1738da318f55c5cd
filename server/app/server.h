// A running talusd, from its first client to its last answer.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include <asio/awaitable.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>
#include <tl/expected.hpp>

#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>

#include "admin/admin_server.h"
#include "app/listeners.h"
#include "app/world_edits.h"
#include "app/world_file.h"
#include "chunks/chunks.h"
#include "chunks/generation/patch_size.h"
#include "cluster/checkpoint/checkpoint_service.h"
#include "config/access/access_control.h"
#include "config/config.h"
#include "limits/flows/flow_uses.h"
#include "limits/memory/memory_budget.h"
#include "limits/memory/trim_policy.h"
#include "limits/rates/rates.h"
#include "net/acceptor.h"
#include "net/admission.h"
#include "net/departures.h"
#include "net/handshaker.h"
#include "net/io_pool.h"
#include "net/registry.h"
#include "net/runner_context.h"
#include "net/tls_context.h"
#include "player/session/world_info.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"
#include "web/site.h"
#include "web/web_context.h"
#include "web/world_files.h"

namespace talus::server {

/// Reads the settings as at the start. An error is one line. Empty if there is not a file to reread.
using ReadSettings = std::function<tl::expected<Config, std::string>()>;

class Server {
 public:
  /// `access` and `clock` must outlive this. `store_id` is sent to clients; 0 if edits are not stored. `tls`:
  /// identity of config.tls; nullopt for plain connections. `site`: files served at / over HTTP; may be null.
  /// `edits`: the store's edits; null if edits are neither stored nor accepted. `columns`: disk cache of
  /// expensive columns; null if disabled. From here on signals wait for run(). Starts no thread before run(),
  /// except the threads of `edits`.
  Server(const Config& config, ServedWorld world, ContentHash store_id, AccessControl& access,
         std::optional<TlsIdentity> tls, Listeners listeners, const Clock& clock, Logger log,
         ReadSettings read_settings = {}, std::shared_ptr<const web::Site> site = nullptr,
         std::unique_ptr<WorldEdits> edits = nullptr, std::unique_ptr<ColumnCache> columns = nullptr);

  /// Serves until SIGTERM or SIGINT, then until every answer is sent or shutdown.drain has passed. SIGHUP
  /// rereads settings, certificates, keys and lists. Call once.
  void run();
  /// Once `wanted` returns true the server ends as after SIGTERM. Call before run(), which polls it.
  void end_where(std::function<bool()> wanted) { end_wanted_ = std::move(wanted); }

 private:
  /// Starts threads, acceptors and coroutines. The first coroutine that ends by an exception sets `failure`
  /// and stops the contexts.
  void start(std::exception_ptr& failure);
  /// Empty without a disk cache.
  [[nodiscard]] RunPregen pregen();
  /// Empty without a store.
  [[nodiscard]] decltype(OperatorAnswers::checkpoint) checkpoints();
  [[nodiscard]] std::string metrics_text();
  [[nodiscard]] FlowsReport flows_report();
  /// Called on the operators' thread.
  [[nodiscard]] Readiness readiness() const;
  [[nodiscard]] RunnerContextPtr make_context(const Config& config);
  [[nodiscard]] web::WebContextPtr make_web_context(const Config& config, const RunnerContextPtr& runner);
  /// Warns if the limit of open files is below what the settings need.
  void check_descriptors(std::uint64_t allowed);
  void on_connection(AcceptedConnection accepted);
  void on_web_connection(AcceptedConnection accepted);
  [[nodiscard]] asio::awaitable<void> wait_for_shutdown();
  [[nodiscard]] asio::awaitable<void> wait_for_reload();
  /// Rereads everything. If it throws, the next reload does the rest.
  void reload();
  /// Changes and logs what can change without a restart, except access, which it returns.
  [[nodiscard]] Access reload_settings();
  /// `changed` takes effect only if nothing fails.
  void change_settings(Config changed);
  /// Takes the lists' paths from `access`.
  void reload_keys(const Access& access);
  void reload_certificate();
  /// Runs periodically: shrinks caches to fit the budget, logs refusals, collects flow usage, and returns
  /// free memory to the system.
  void housekeeping();
  void give_memory_back();
  void collect_flows();
  /// Logs when the store becomes unwritable or writable again, and accounts for its memory.
  void watch_edits();
  void watch_clock(const BatchDates::Jumps& jumps);
  /// True if the edit cache fits what the budget leaves for it.
  [[nodiscard]] bool fit_edit_cache();
  /// Reports not ready, and accepts connections for shutdown.lead.
  void drain();
  /// Stops accepting connections, and ends all sessions.
  void end_sessions();
  void balancer_says(const std::string& state, const std::string& query);
  void stop_handling_signals();
  void end_operators();

  // Destroyed in reverse order: generator threads post to the contexts, and connections in the contexts hold
  // slots and are in the registry.
  Config config_;  // current; only the main thread while it runs
  const std::uint64_t history_limit_bytes_;
  const ReadSettings read_settings_;
  const Clock& clock_;
  Logger log_;
  Logger log_of_clients_;
  AccessControl& access_;
  const std::shared_ptr<const terrain::World> terrain_;
  const WorldInfo world_;
  const std::uint64_t generator_version_;
  const PatchSize patch_size_;
  const std::shared_ptr<const web::Site> site_;
  const std::shared_ptr<const web::WorldFiles> world_files_;  // null: not published
  const std::uint64_t site_bytes_;                            // and those of world_files_
  CurrentRates rates_;
  FlowUses flows_;
  Metrics metrics_;
  MemoryBudget memory_;  // connections release memory to it
  Admission admission_;
  Registry registry_;
  std::optional<TlsIdentity> tls_;                      // used by the control thread
  std::atomic<Clock::time_point> last_housekeeping_{};  // set by the main thread, to check its health
  std::atomic<std::int64_t> certificate_expires_;
  std::atomic<bool> draining_ = false;
  Handshaker handshaker_;
  Handshaker web_handshaker_;
  std::atomic<std::uint64_t> web_answers_{0};
  std::atomic<std::uint64_t> web_fetches_{0};
  web::RecentRevisions recent_revisions_;
  std::unique_ptr<IoPool> io_;
  const std::unique_ptr<WorldEdits> edits_;  // null: edits are not stored
  Chunks chunks_;
  mutable std::mutex context_mutex_;
  RunnerContextPtr context_;        // for new sessions; guarded by context_mutex_
  web::WebContextPtr web_context_;  // for new HTTP connections; guarded in the same way

  std::unique_ptr<Acceptor> acceptor_;
  std::unique_ptr<Acceptor> web_acceptor_;  // null: HTTP is disabled
  asio::signal_set shutdown_signals_;
  asio::signal_set reload_signals_;
  asio::steady_timer drain_timer_;
  Departures departures_;
  std::set<std::string> told_of_queries_;  // malformed balancer queries already logged
  asio::steady_timer housekeeping_timer_;
  TrimPolicy trim_policy_;
  Clock::time_point memory_checked_at_{};
  Clock::time_point flows_collected_at_{};
  Clock::time_point edits_checked_at_{};
  std::size_t edit_cache_bytes_ = 0;  // its capacity; 0: not changed yet
  bool edits_watched_ = false;
  std::string edits_trouble_;      // as last logged
  std::uint64_t clock_jumps_ = 0;  // as last logged
  std::function<bool()> end_wanted_;
  ConnectionId last_id_ = 0;
  std::unique_ptr<CheckpointService> checkpoints_;  // null: there is no store
  std::unique_ptr<AdminServer> operators_;          // its thread reads everything above
  std::atomic<bool> trims_ = false;                 // true while trimming_ runs
  std::jthread trimming_;
};

}  // namespace talus::server
