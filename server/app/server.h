// A running talusd: from its first client to its last answer.
#pragma once

#include <atomic>
#include <cstdint>
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
#include "chunks/generation/base_chunks.h"
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
#include "net/session_runner.h"
#include "net/tls_context.h"
#include "player/session/world_info.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"
#include "web/site.h"
#include "web/web_context.h"

namespace talus::server {

/// Reads the settings as at the start; an error is one line. None: there is no file that may have changed.
using ReadSettings = std::function<tl::expected<Config, std::string>()>;

class Server {
 public:
  /// `access` and `clock` outlive it. `store_id`: what clients are told; 0 where nothing is kept. `tls`: of
  /// config.tls; none where connections are plain. `site`: files at / of HTTP; null: none. `edits`: those of
  /// the store; null: none are kept, and none are taken. `columns`: what was dear to generate; null: it is
  /// not kept on disk. From here on signals wait for run(). No thread is started before run(), but those of
  /// `edits`.
  Server(const Config& config, std::shared_ptr<const terrain::World> world, ContentHash store_id,
         AccessControl& access, std::optional<TlsIdentity> tls, Listeners listeners, const Clock& clock,
         Logger log, ReadSettings read_settings = {}, std::shared_ptr<const web::Site> site = nullptr,
         std::unique_ptr<WorldEdits> edits = nullptr, std::unique_ptr<ColumnCache> columns = nullptr);

  /// Serves until SIGTERM or SIGINT, and then until every answer is sent or shutdown.drain is over. SIGHUP
  /// reads settings, certificates, keys and lists again. Once.
  void run();
  /// It ends as by SIGTERM once that is true; before run(). Asked often, on the main thread.
  void end_where(std::function<bool()> wanted) { end_wanted_ = std::move(wanted); }

 private:
  /// Empty where nothing is kept on disk.
  [[nodiscard]] RunPregen pregen();
  /// Empty where nothing is kept on disk.
  [[nodiscard]] decltype(OperatorAnswers::checkpoint) checkpoints();
  [[nodiscard]] std::string metrics_text();
  [[nodiscard]] FlowsReport flows_report();
  /// Asked on the operators' thread.
  [[nodiscard]] Readiness readiness() const;
  [[nodiscard]] RunnerContextPtr make_context(const Config& config);
  [[nodiscard]] web::WebContextPtr make_web_context(const Config& config, const RunnerContextPtr& runner);
  /// Warns where the limit of open files is less than the settings need.
  void check_descriptors(std::uint64_t allowed);
  void on_connection(AcceptedConnection accepted);
  void on_web_connection(AcceptedConnection accepted);
  [[nodiscard]] asio::awaitable<void> wait_for_shutdown();
  [[nodiscard]] asio::awaitable<void> wait_for_reload();
  /// Reads everything again. Where it throws, the next one does the rest.
  void reload();
  /// Changes what can be without a restart but for access, which it returns, and says what has changed.
  [[nodiscard]] Access reload_settings();
  /// `changed` is in use when nothing has failed.
  void change_settings(Config changed);
  /// Takes the lists' paths from `access`.
  void reload_keys(const Access& access);
  void reload_certificate();
  /// Lets caches give way to everything else, logs refusals, collects what flows have used, and gives free
  /// memory back, all the time.
  void housekeeping();
  void give_memory_back();
  void collect_flows();
  /// Says when the store cannot be written, and when it can again, and counts its memory.
  void watch_edits();
  /// Whether the cache of edits fits what the budget leaves it.
  [[nodiscard]] bool fit_edit_cache();
  /// Ready no more; accepts connections for shutdown.lead.
  void drain();
  /// Accepts none any more, and sends everybody away.
  void end_sessions();
  void balancer_says(const std::string& state, const std::string& query);
  void stop_handling_signals();
  void end_operators();

  // In the order in which they may be destroyed, last first: generator threads post to the contexts, and
  // connections in the contexts hold slots and stand in the registry.
  Config config_;  // in use; of the main thread once it runs
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
  const std::uint64_t site_bytes_;
  CurrentRates rates_;
  FlowUses flows_;
  Metrics metrics_;
  MemoryBudget memory_;  // connections give back to it
  Admission admission_;
  Registry registry_;
  std::optional<TlsIdentity> tls_;                      // of the control thread
  std::atomic<Clock::time_point> last_housekeeping_{};  // of the main thread, for its health
  std::atomic<std::int64_t> certificate_expires_;
  std::atomic<bool> draining_ = false;
  Handshaker handshaker_;
  Handshaker web_handshaker_;
  std::atomic<std::uint64_t> web_answers_{0};
  std::atomic<std::uint64_t> web_fetches_{0};
  web::RecentRevisions recent_revisions_;
  std::unique_ptr<IoPool> io_;
  const std::unique_ptr<WorldEdits> edits_;  // null: none are kept
  BaseChunks chunks_;                        // as generated
  ChunkSource& chunks_with_edits_;
  mutable std::mutex context_mutex_;
  RunnerContextPtr context_;        // of sessions to come; changes under the mutex
  web::WebContextPtr web_context_;  // the same of HTTP connections

  std::unique_ptr<Acceptor> acceptor_;
  std::unique_ptr<Acceptor> web_acceptor_;  // null: no HTTP for players
  asio::signal_set shutdown_signals_;
  asio::signal_set reload_signals_;
  asio::steady_timer drain_timer_;
  Departures departures_;
  std::set<std::string> told_of_queries_;  // of balancers, that are not understood
  asio::steady_timer housekeeping_timer_;
  TrimPolicy trim_policy_;
  Clock::time_point last_look_at_memory_{};
  Clock::time_point last_look_at_flows_{};
  Clock::time_point last_look_at_edits_{};
  std::size_t edit_cache_bytes_ = 0;            // its capacity; 0: as it was made
  std::optional<std::string> edits_read_only_;  // as the log was told
  std::function<bool()> end_wanted_;
  ConnectionId last_id_ = 0;
  std::unique_ptr<CheckpointService> checkpoints_;  // null: there is no store to take
  std::unique_ptr<AdminServer> operators_;          // its thread reads everything above
  std::atomic<bool> trims_ = false;                 // whether trimming_ is at work
  std::jthread trimming_;
};

}  // namespace talus::server
