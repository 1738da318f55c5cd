#include "app/server.h"

#include <malloc.h>

#include <chrono>
#include <csignal>
#include <exception>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <asio/co_spawn.hpp>
#include <asio/post.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/terrain/places.h>
#include <talus/vectors/instruction_set.h>

#include "app/process_signals.h"
#include "app/readiness.h"
#include "app/reload.h"
#include "app/settings.h"
#include "chunks/generation/terrain_generator.h"
#include "config/access/auth_failure.h"
#include "limits/rates/rate_kind.h"
#include "net/balancer_state.h"
#include "net/descriptors.h"
#include "net/refusal_reason.h"
#include "player/session/retry_after.h"
#include "runtime/log/escape.h"
#include "runtime/metrics/metrics_page.h"
#include "runtime/metrics/process.h"
#include "runtime/signals.h"
#include "web/error_answers.h"
#include "web/web_connection.h"

namespace talus::server {
namespace {

constexpr std::chrono::milliseconds kHousekeepingInterval{50};
constexpr std::chrono::seconds kMemoryCheckInterval{1};
constexpr std::chrono::seconds kFlowsCollectInterval{1};
constexpr std::chrono::seconds kEditsCheckInterval{1};
constexpr std::size_t kTopFlows = 10;
// The main thread counts as hung after this long without housekeeping.
constexpr std::chrono::seconds kMaxSilence{15};

WorldInfo describe_world(const ServedWorld& served, ContentHash store_id, const WorldEdits* edits) {
  const terrain::World& world = *served.world;
  auto materials = world.materials();
  if (edits != nullptr) {
    materials.insert(materials.end(), edits->placeables().begin(), edits->placeables().end());
  }
  return {world.fingerprint(),        store_id,
          std::move(materials),       terrain::height_range(world),
          terrain::find_spawn(world), "talusd " TALUS_VERSION,
          world.look_names(),         terrain::place_names(world),
          served.published,           served.published ? web::world_file_path(world.fingerprint()) : ""};
}

}  // namespace

Server::Server(const Config& config, ServedWorld world, ContentHash store_id, AccessControl& access,
               std::optional<TlsIdentity> tls, Listeners listeners, const Clock& clock, Logger log,
               ReadSettings read_settings, std::shared_ptr<const web::Site> site,
               std::unique_ptr<WorldEdits> edits, std::unique_ptr<ColumnCache> columns)
    : config_{config},
      history_limit_bytes_{config.edits.history_bytes},
      read_settings_{std::move(read_settings)},
      clock_{clock},
      log_{std::move(log)},
      log_of_clients_{for_clients(log_)},
      access_{access},
      terrain_{world.world},
      world_{describe_world(world, store_id, edits.get())},
      generator_version_{static_cast<std::uint64_t>(to_integer(terrain_->generator_version()))},
      patch_size_{measured_patch_size(config, *terrain_, clock)},
      site_{std::move(site)},
      world_files_{world.published ? std::make_shared<const web::WorldFiles>(world.published) : nullptr},
      site_bytes_{files_bytes(site_.get(), world.published.get())},
      rates_{rate_limits(config, site_bytes_)},
      memory_{config.limits.memory_bytes, io_threads(config) + generator_threads(config)},
      admission_{admission_limits(config, site_bytes_), clock},
      tls_{std::move(tls)},
      certificate_expires_{tls_ ? tls_->expires : 0},
      handshaker_{handshake_settings(config),
                  admission_,
                  access_,
                  flows_,
                  metrics_,
                  memory_,
                  clock,
                  log_of_clients_,
                  [this](AcceptedConnection accepted) { on_connection(std::move(accepted)); }},
      web_handshaker_{web_handshake_settings(config),
                      admission_,
                      access_,
                      flows_,
                      metrics_,
                      memory_,
                      clock,
                      log_of_clients_,
                      [this](AcceptedConnection accepted) { on_web_connection(std::move(accepted)); },
                      web::refusal_response},
      io_{std::move(listeners.io)},
      edits_{std::move(edits)},
      chunks_{std::make_unique<TerrainGenerator>(terrain_, patch_size_.tiles, generator_threads(config),
                                                 ground_bytes(config, *terrain_)),
              generation_settings(config, *terrain_, patch_size_),
              log_,
              metrics_,
              memory_,
              clock,
              edits_ == nullptr ? std::nullopt : std::optional{edits_->of_chunks()},
              std::move(columns)},
      acceptor_{std::move(listeners.players)},
      web_acceptor_{std::move(listeners.web)},
      shutdown_signals_{io_->control(), SIGTERM, SIGINT},
      reload_signals_{io_->control(), SIGHUP},
      drain_timer_{io_->control()},
      departures_{io_->control(), registry_, clock_},
      housekeeping_timer_{io_->control()},
      operators_{std::move(listeners.operators)} {
  if (edits_ != nullptr) {
    edits_->join(*terrain_, chunks_, metrics_, config.edits.settle);
    log_->info("edits: store {} at revision {}", to_string(store_id), edits_->state().revision());
  }
  context_ = make_context(config_);
  web_context_ = make_web_context(config_, context_);
  memory_.add(MemoryUse::program, static_cast<std::int64_t>(site_bytes_));
}

RunnerContextPtr Server::make_context(const Config& config) {
  struct OwnedContext {
    SessionLimits limits;
    RunnerContext context;
    OwnedContext(const SessionLimits& of_sessions, const RunnerLimits& of_runners, std::string place,
                 Server& server)
        : limits{of_sessions},
          context{{limits, server.world_, server.chunks_, server.memory_, server.metrics_, server.access_,
                   server.rates_, server.flows_, server.clock_,
                   server.edits_ == nullptr ? nullptr : &server.edits_->taker()},
                  of_runners,
                  server.registry_,
                  server.log_of_clients_,
                  std::move(place)} {}
  };
  SessionLimits limits = session_limits(config, *terrain_, world_.spawn, patch_size_.tile_time);
  limits.view_base = world_.published != nullptr;
  const auto kept =
      std::make_shared<const OwnedContext>(limits, runner_limits(config), http_place(config), *this);
  return {kept, &kept->context};
}

web::WebContextPtr Server::make_web_context(const Config& config, const RunnerContextPtr& runner) {
  return std::make_shared<const web::WebContext>(web::WebContext{
      runner, edits_.get(), web_settings(config), admission_, web_service(config, clock_, log_of_clients_),
      to_string(world_.fingerprint), to_string(world_.store_id), web_answers_, web_fetches_,
      recent_revisions_, site_,
      std::make_shared<web::WorldDocument>(world_, runner->session.limits, edits_.get()), world_files_});
}

std::string Server::metrics_text() {
  const Chunks::State status = chunks_.status();
  RuntimeGauges gauges{
      status.jobs, status.clients, status.chunk_cache_bytes, status.patch_cache_bytes, status.map_cache_bytes,
      draining_};
  if (const auto& columns = status.columns) {
    gauges.columns = {columns->found, columns->missing, columns->kept, columns->lost, columns->bytes};
  }
  for (std::size_t use = 0; use < kMemoryUses.size(); ++use) {
    gauges.memory_bytes.push_back(memory_.used(static_cast<MemoryUse>(use)));
  }
  gauges.memory_limit_bytes = memory_.limit_bytes();
  gauges.flows = flows_.flows();
  gauges.flow_refusals = flows_.refusals();
  gauges.certificate_expires = certificate_expires_;
  if (edits_ != nullptr) {
    if (const cluster::ClusterLog* const shared = edits_->shared()) {
      const cluster::ClusterLog::State at = shared->status();
      gauges.cluster = {at.connected,    at.quorum,        at.differs, at.lag,
                        at.sequence,     at.republished,   at.gaps,    &shared->publish_latency(),
                        edits_->joins(), at.skipped,       at.bounded, at.stuck,
                        at.late.empty(), at.false_messages};
    }
    const LocalLog::State log = edits_->status();
    const bool is_troubled = !edits_trouble(log.read_only, log.disk_wait).empty();
    const EditState& state = edits_->state();
    const store::HistorySpan history = edits_->history();
    gauges.edits = {log.head.revision,    edits_->preparing(),     log.waiting,          state.editor_count(),
                    is_troubled,          state.index().bytes(),   state.index_limit(),  history.bytes,
                    history_limit_bytes_, history.since_ms / 1000, log.clock_jumps.count};
  }
  std::vector<std::string_view> error_codes{""};  // code 0, "none", is not an error
  for (std::size_t code = 1; code <= static_cast<std::size_t>(wire::ErrorCode::MAX); ++code) {
    error_codes.emplace_back(wire::EnumNameErrorCode(static_cast<wire::ErrorCode>(code)));
  }
  const MetricLabels labels{kRefusalNames, error_codes,    kAuthFailureNames, kRateNames,
                            kMemoryUses,   kStatusClasses, kEditErrorNames};
  const BuildInfo build{TALUS_VERSION, generator_version_, to_string(world_.fingerprint),
                        std::string{to_string(instruction_set())}};
  return metrics_page({metrics_, gauges, read_process(), build, labels});
}

Readiness Server::readiness() const {
  if (edits_ == nullptr) return readiness_of(draining_, nullptr, nullptr, memory_);
  if (edits_->shared() == nullptr) {
    const LocalLog::State own = edits_->status();
    return readiness_of(draining_, nullptr, &own, memory_);
  }
  const cluster::ClusterLog::State shared = edits_->shared()->status();
  return readiness_of(draining_, &shared, nullptr, memory_);
}

FlowsReport Server::flows_report() {
  return {static_cast<std::uint64_t>(metrics_.open.now()), flows_.flows(), flows_.top(kTopFlows)};
}

void Server::check_descriptors(std::uint64_t allowed) {
  if (const std::uint64_t wanted = descriptors_wanted(config_); allowed < wanted) {
    log_->warn(
        "the system allows {} open files, fewer than the {} that limits.connections {} needs; raise ulimit "
        "-n",
        allowed, wanted, config_.limits.connections);
  }
}

void Server::run() {
  std::exception_ptr failure;
  try {
    start(failure);
    io_->run();
  } catch (...) {
    failure = std::current_exception();
  }
  stop_handling_signals();
  if (edits_ != nullptr) edits_->stop();  // while generators and mailboxes still exist
  end_operators();
  handshaker_.refusal_log().flush({});
  web_handshaker_.refusal_log().flush({});
  if (failure) std::rethrow_exception(failure);
}

void Server::start(std::exception_ptr& failure) {
  check_descriptors(set_descriptor_limit(descriptors_wanted(config_)));
  log_->log(patch_size_.expensive || patch_size_.chunks_expensive() ? LogLevel::warn : LogLevel::info, "{}",
            describe(patch_size_));
  chunks_.start();
  if (edits_ != nullptr) edits_->start(pregen());
  if (operators_) {
    last_housekeeping_ = clock_.now();
    OperatorAnswers answers{[this] { return metrics_text(); },
                            [this] { return clock_.now() - last_housekeeping_.load() < kMaxSilence; },
                            [this] { return readiness(); }, [this] { return flows_report(); }};
    answers.checkpoint = checkpoints();
    answers.balancer_says = [this](const std::string& state, const std::string& query) {
      asio::post(io_->control(), [this, state, query] { balancer_says(state, query); });
    };
    operators_->start(std::move(answers));
  }
  // The server cannot run without any of these.
  const auto end = [this, &failure](const std::exception_ptr& thrown) {
    if (!thrown) return;
    failure = thrown;
    io_->stop();
  };
  asio::io_context& control = io_->control();
  acceptor_->start([this]() -> asio::io_context& { return io_->next(); },
                   [this](asio::ip::tcp::socket socket) {
                     handshaker_.begin(std::move(socket), ++last_id_, tls_ ? tls_->context : nullptr);
                   });
  if (web_acceptor_ != nullptr) {
    const bool by_tls = tls_ && config_.http.tls;
    web_acceptor_->start([this]() -> asio::io_context& { return io_->next(); },
                         [this, by_tls](asio::ip::tcp::socket socket) {
                           web_handshaker_.begin(std::move(socket), ++last_id_,
                                                 by_tls ? tls_->context : nullptr);
                         });
  }
  asio::co_spawn(control, wait_for_shutdown(), end);
  asio::co_spawn(control, wait_for_reload(), end);
  housekeeping();
}

void Server::end_operators() {
  if (operators_ != nullptr) operators_->stop();
  if (checkpoints_ != nullptr) checkpoints_->stop();  // its threads answer to the operators' connections
  operators_.reset();
  checkpoints_.reset();
}

// Destroying caches takes time; with default handlers a signal would kill a process that is ending cleanly.
void Server::stop_handling_signals() {
  sigset_t ours;
  sigset_t before;
  sigemptyset(&ours);
  for (const int signal : {SIGHUP, SIGTERM, SIGINT}) sigaddset(&ours, signal);
  ::pthread_sigmask(SIG_BLOCK, &ours,
                    &before);  // asio restores the default handlers first; generators block signals
  std::error_code ignored;
  reload_signals_.clear(ignored);
  shutdown_signals_.clear(ignored);
  end_at_once_on_signals();
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

decltype(OperatorAnswers::checkpoint) Server::checkpoints() {
  if (edits_ == nullptr) return {};
  const SignalBlocker blocked;
  checkpoints_ = std::make_unique<CheckpointService>(
      CheckpointService::Parts{access_, metrics_, clock_, config_.data,
                               [this](const auto& path) { return edits_->checkpoint(path); }},
      config_.rates.checkpoint_bytes, log_);
  return [this](const http::Request& request, const std::string& address, std::function<void()> close) {
    return checkpoints_->respond(request, address, std::move(close));
  };
}

RunPregen Server::pregen() {
  const auto columns = column_cache_settings(config_, world_.fingerprint);
  if (!columns) return {};
  Pregen::Parts parts{chunks_,
                      [this] { return chunks_.status().clients > 0; },
                      clock_,
                      generator_threads(config_),
                      pregen_file(*columns),
                      [this] { chunks_.keep_on_disk(); }};
  return [run = std::make_shared<Pregen>(std::move(parts))](const PregenPlan& plan, const auto& report) {
    return run->run(plan, report);
  };
}

void Server::on_connection(AcceptedConnection accepted) {
  log_->debug("conn {} {}: opened", accepted.info.id, accepted.info.address);
  RunnerContextPtr context;
  {
    const std::lock_guard lock{context_mutex_};
    context = context_;
  }
  start_session(std::move(accepted), context);
}

void Server::on_web_connection(AcceptedConnection accepted) {
  web::WebContextPtr context;
  {
    const std::lock_guard lock{context_mutex_};
    context = web_context_;
  }
  web::start_connection(std::move(accepted), context);
}

asio::awaitable<void> Server::wait_for_reload() {
  for (;;) {
    co_await reload_signals_.async_wait(asio::use_awaitable);
    try {
      reload();
    } catch (const std::exception& error) {  // such as bad_alloc: not a reason to end
      log_->error(
          "SIGHUP: {}; the old settings stay in use, except the settings named above; send SIGHUP again",
          on_one_line(error.what()));
    }
  }
}

void Server::reload() {
  const bool had_keys = config_.access.wanted();
  if (!read_settings_ && !had_keys && !tls_) {
    log_->info("SIGHUP: nothing to read again: no settings, keys, lists or certificate are in a file");
  }
  Access access = config_.access;
  if (read_settings_) access = reload_settings();
  if (had_keys || access.wanted()) reload_keys(access);
  if (tls_) reload_certificate();
}

Access Server::reload_settings() {
  const auto fresh = read_settings_();
  if (!fresh) {
    log_->error("SIGHUP: {}; the old settings stay in use", fresh.error());
    return config_.access;
  }
  const auto changes = changes_between(config_, *fresh);
  if (changes.empty()) log_->info("SIGHUP: no setting has changed");
  Config changed = changed_while_running(config_, *fresh);
  Access wanted = std::exchange(changed.access, config_.access);  // kept until its files are read
  if (!changes.empty()) change_settings(std::move(changed));
  // Logged only after the change succeeded.
  for (const SettingChange& change : changes) {
    const bool waits = change.counts == Counts::after_restart;
    log_->log(waits ? LogLevel::warn : LogLevel::info, "SIGHUP: {}", change.line);
  }
  return wanted;
}

void Server::change_settings(Config changed) {
  auto context = make_context(changed);
  auto web_context = make_web_context(changed, context);
  handshaker_.change(handshake_settings(changed));
  web_handshaker_.change(web_handshake_settings(changed));
  rates_.set(rate_limits(changed, site_bytes_));
  if (checkpoints_ != nullptr) checkpoints_->set_rate(changed.rates.checkpoint_bytes);
  admission_.change(admission_limits(changed, site_bytes_));
  registry_.rates_changed();
  config_ = std::move(changed);
  {
    const std::lock_guard lock{context_mutex_};
    context_.swap(context);
    web_context_.swap(web_context);
  }
  check_descriptors(raise_descriptor_limit(descriptors_wanted(config_)));
}

void Server::reload_keys(const Access& access) {
  if (const auto reloaded = access_.reload(access)) {
    config_.access = access;
    log_->info("SIGHUP: {}", *reloaded);
    registry_.access_changed();
  } else {
    log_->error("SIGHUP: {}", reloaded.error());
  }
}

void Server::reload_certificate() {
  auto loaded = load_tls(config_.tls.certificate, config_.tls.key, clock_.wall());
  if (loaded) {
    tls_ = *std::move(loaded);
    certificate_expires_ = tls_->expires;
    log_->info("SIGHUP: TLS with {} from now on", tls_->description);
  } else {
    log_->error("SIGHUP: {}; new connections still get the old one: {}", loaded.error(), tls_->description);
  }
}

void Server::housekeeping() {
  last_housekeeping_ = clock_.now();
  const bool edits_fit = fit_edit_cache();
  const bool caches_fit = chunks_.fit_caches() && edits_fit;
  handshaker_.refusal_log().flush();
  web_handshaker_.refusal_log().flush();
  memory_.end_still_sessions(clock_.now());
  collect_flows();
  watch_edits();
  if (end_wanted_ && !draining_ && end_wanted_()) drain();
  give_memory_back();
  // Lets sockets that are ready run before the next slice.
  housekeeping_timer_.expires_after(caches_fit ? kHousekeepingInterval : std::chrono::milliseconds{0});
  housekeeping_timer_.async_wait([this](std::error_code cancelled) {
    if (!cancelled) housekeeping();
  });
}

bool Server::fit_edit_cache() {
  if (edits_ == nullptr) return true;
  EditState& state = edits_->state();
  const auto allowed =
      static_cast<std::size_t>(memory_.for_edit_cache(state.cache_limit() + EditIntake::kBaseBytes));
  if (allowed != edit_cache_bytes_) {
    edit_cache_bytes_ = allowed;
    const std::size_t bases = std::min(EditIntake::kBaseBytes, allowed / 4);
    edits_->limit_bases(bases);
    state.set_cache_capacity(allowed - bases);
  }
  const bool fits = state.fit_cache();
  memory_.set(MemoryUse::edit_cache, state.cache_bytes() + edits_->base_bytes());
  return fits;
}

void Server::watch_edits() {
  if (edits_ == nullptr) return;
  const auto now = clock_.now();
  if (now - edits_checked_at_ < kEditsCheckInterval) return;
  edits_checked_at_ = now;
  memory_.set(MemoryUse::edits, edits_->state().bytes());
  memory_.set(MemoryUse::store, edits_->store_bytes());
  chunks_.count_columns();
  const LocalLog::State status = edits_->status();
  watch_clock(status.clock_jumps);
  std::string trouble = edits_trouble(status.read_only, status.disk_wait);
  // A member of a cluster looks for its place in the log when it starts.
  if (!std::exchange(edits_watched_, true) || trouble == edits_trouble_) return;
  if (trouble.empty()) {
    log_->info("edits are taken again");
  } else {
    log_->error("{}", trouble);
  }
  edits_trouble_ = std::move(trouble);
}

void Server::watch_clock(const BatchDates::Jumps& jumps) {
  if (jumps.count == std::exchange(clock_jumps_, jumps.count)) return;
  if (jumps.last.count() > 0) {
    log_->error(
        "this machine's clock jumped {} s ahead; for {} minutes edits are dated as if it had not; "
        "synchronize it by NTP",
        jumps.last.count(), BatchDates::kPatience.count());
  } else {
    log_->error(
        "the last edit was dated {} s ahead of this machine's clock; for {} minutes edits keep that date; "
        "synchronize it by NTP",
        -jumps.last.count(), BatchDates::kPatience.count());
  }
}

void Server::collect_flows() {
  const auto now = clock_.now();
  if (now - flows_collected_at_ < kFlowsCollectInterval) return;
  flows_collected_at_ = now;
  try {
    flows_.collect(now);
  } catch (const std::exception& error) {  // the next collection does the rest
    log_->warn("cannot collect what flows use: {}", error.what());
  }
}

void Server::give_memory_back() {
  const auto now = clock_.now();
  if (now - memory_checked_at_ < kMemoryCheckInterval) return;
  memory_checked_at_ = now;
#ifdef __GLIBC__
  if (trims_ || !trim_policy_.due(memory_.used())) return;
  // On a separate thread, because this one serves players and the system call is slow.
  trims_ = true;
  try {
    trimming_ = std::jthread{[this] {  // the previous thread has ended, so this does not block
      block_signals();
      ::malloc_trim(0);
      log_->debug("free memory was given back to the system, in {} us of processor time",
                  std::chrono::duration_cast<std::chrono::microseconds>(clock_.thread_cpu()).count());
      trims_ = false;
    }};
  } catch (const std::exception& error) {
    trims_ = false;
    log_->warn("cannot give free memory back to the system: {}", error.what());
  }
#endif
}

asio::awaitable<void> Server::wait_for_shutdown() {
  const int first = co_await shutdown_signals_.async_wait(asio::use_awaitable);
  const std::string_view signal = first == SIGINT ? "SIGINT" : "SIGTERM";
  if (draining_) {
    log_->info("{}: the server is ending already; {} connections", signal, admission_.connections());
  } else if (config_.shutdown.lead.count() == 0) {
    log_->info("{}: no new connections; {} are asked to leave", signal, admission_.connections());
  } else {
    log_->info("{}: not ready any more; {} connections, and new ones for {} ms", signal,
               admission_.connections(), config_.shutdown.lead.count());
  }
  if (!draining_) drain();
  co_await shutdown_signals_.async_wait(asio::use_awaitable);
  log_->warn("a second signal: ending at once");
  io_->stop();
}

void Server::drain() {
  draining_ = true;
  if (config_.shutdown.lead.count() == 0) return end_sessions();
  drain_timer_.expires_after(config_.shutdown.lead);
  drain_timer_.async_wait([this](std::error_code cancelled) {
    if (!cancelled) end_sessions();
  });
}

void Server::end_sessions() {
  acceptor_->close();
  if (web_acceptor_ != nullptr) web_acceptor_->close();
  if (config_.shutdown.lead.count() == 0) {
    registry_.tell_all_to_go("the server is ending", retry_after::kShutdown);
  } else {
    log_->info("no new connections; {} are asked to go to other servers", admission_.connections());
    departures_.send_all(config_.shutdown.drain / 2);
  }
  registry_.when_empty([this] { asio::post(io_->control(), [this] { io_->stop(); }); });
  drain_timer_.expires_after(config_.shutdown.drain);
  drain_timer_.async_wait([this](std::error_code cancelled) {
    if (cancelled) return;
    log_->warn("{} connections were still open after {} ms", admission_.connections(),
               config_.shutdown.drain.count());
    io_->stop();
  });
}

void Server::balancer_says(const std::string& state, const std::string& query) {
  if (draining_) return;
  BalanceSettings settings = balance_settings(config_);
  const auto asked = read_balancer_query(query);
  if (!asked) {
    // Checks come every second, so each distinct mistake is logged once, up to a limit.
    constexpr std::size_t kTold = 8;
    if (told_of_queries_.size() < kTold && told_of_queries_.insert(asked.error()).second) {
      log_->warn("balance: a balancer's check is ignored: in its query {}", on_one_line(asked.error()));
    }
    return;
  }
  settings.above_percent = asked->above_percent.value_or(settings.above_percent);
  const std::size_t sent = departures_.balancer_says(state, settings, asked->ports);
  if (sent == 0) return;
  metrics_.sent_elsewhere.add(sent);
  log_->info("balance: {} sessions are sent to other servers: {}", sent, on_one_line(state));
}

}  // namespace talus::server
