#include "app/world_edits.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <talus/edits/materials.h>
#include <talus/local/settle_rules.h>
#include <talus/store/read_only_store.h>
#include <talus/terrain/extraction.h>

#include "app/bound_materials.h"
#include "edits/admission/log_admission.h"
#include "runtime/signals.h"

namespace talus::server {
namespace {

/// Maximum wait for an unreachable log at the start of a server that has a store.
constexpr std::chrono::seconds kLogAway{10};

/// All materials that the world names, including air and water. `world` outlives the rules.
EditIntake::Rules rules_of(const terrain::World& world, const std::vector<terrain::Material>& placeables,
                           bool settles) {
  EditIntake::Rules rules{terrain::height_range(world), {}, nullptr};
  if (world.has_secrets()) {
    rules.hidden = [&world](ChunkCoord chunk, const Chunk& shown) {
      return terrain::hidden_ore(world, chunk, shown);
    };
  }
  if (settles) rules.settles = std::make_shared<const edits::SettleRules>(local::settle_rules(world));
  for (const auto* const materials : {&world.materials(), &placeables}) {
    for (const terrain::Material& material : *materials) {
      rules.materials.push_back(material.id);
      const bool fluid =
          material.kind == terrain::MaterialKind::air || material.kind == terrain::MaterialKind::water;
      if (fluid) rules.see_through.push_back(material.id);
    }
  }
  std::ranges::sort(rules.materials);
  std::ranges::sort(rules.see_through);
  return rules;
}

}  // namespace

tl::expected<std::unique_ptr<WorldEdits>, std::string> WorldEdits::open(
    const std::filesystem::path& directory, const terrain::World& world, ContentHash store_id,
    const Clock& clock, Logger log, const EditStateSettings& state_settings, store::HistoryLimits history,
    store::StoreMemory memory, SharedLog shared) {
  const SignalBlocker blocked;  // for RocksDB's threads
  store::EditDatabaseSettings settings;
  settings.path = directory;
  settings.fingerprint = world.fingerprint();
  settings.store_id = store_id;
  settings.history = history;
  settings.memory = memory;
  settings.log_elsewhere = shared.stream != nullptr;
  settings.on_lost_end = shared.on_lost_end;
  auto database = store::EditDatabase::open(settings);
  if (!database) return tl::unexpected{std::move(database.error())};
  if (!(*database)->dropped().empty()) log->warn("data {}: {}", directory.string(), (*database)->dropped());
  if (shared.stream == nullptr && (*database)->meta().stream.sequence != 0) {
    return tl::unexpected{fmt::format(
        "data {}: the store belongs to a cluster, whose log has the next edits; give cluster.nats its NATS "
        "servers, or take the store out of the cluster by talusd store leave-cluster",
        directory.string())};
  }
  if (const ContentHash now = (*database)->meta().store_id; now != store_id) {
    log->warn("data {}: the file acknowledged is gone, so edits may be lost; the store has a new id, {}",
              directory.string(), to_string(now));
  }
  auto state = EditState::open(**database, state_settings);
  if (!state) {
    // Another server's store replaces it at the next start.
    if (shared.stream != nullptr && store::ReadOnlyStore::is_damaged(directory)) {
      shared.on_lost(cluster::StoreLoss::wrong_state, state.error());
    }
    return tl::unexpected{std::move(state.error())};
  }
  std::unique_ptr<WorldEdits> edits{new WorldEdits{*std::move(database), *std::move(state), clock, log}};
  edits->writer_settings_.flush_bytes = state_settings.dirty_bytes;
  if (const auto named = edits->name_placeables(world, std::move(shared)); !named) {
    return tl::unexpected{named.error()};
  }
  return edits;
}

store::EditDatabase::Status WorldEdits::name_placeables(const terrain::World& world, SharedLog shared) {
  const auto names = names_without_ids(world, *database_, *state_);
  if (!names) return tl::unexpected{names.error()};
  edits::MaterialIds ids = database_->materials();
  if (shared.stream != nullptr) {
    start_shared_log(std::move(shared), world);
    // Waits while the server would not be ready anyway, and some time for a new leader.
    std::optional<std::chrono::steady_clock::time_point> away;
    const auto waits = [&] {
      const cluster::ClusterLog::State status = shared_->status();
      const auto now = std::chrono::steady_clock::now();
      if (!status.ready || status.quorum) {
        away.reset();
      } else if (!away) {
        away = now;
      }
      return !away || now - *away < kLogAway;
    };
    const auto given = bind_by_log(*names, *log_, logger_, waits);
    if (!given) return tl::unexpected{given.error()};
    ids.insert(given->begin(), given->end());
  } else if (!names->empty()) {
    const auto given = edits::ids_for(*names, ids);
    if (!given) return tl::unexpected{fmt::format("data {}: ids end", database_->path().string())};
    edits::MaterialIds added{given->begin(), given->end()};
    if (auto bound = database_->bind(added); !bound) return bound;
    ids.merge(added);
  }
  for (const terrain::Placeable& placeable : world.placeables()) {
    const auto id = ids.find(placeable.name);
    if (id == ids.end()) continue;  // the log was unreachable
    placeables_.push_back({id->second, placeable.name, placeable.colour, placeable.kind});
  }
  return {};
}

void WorldEdits::start_shared_log(SharedLog shared, const terrain::World& world) {
  stream_ = std::move(shared.stream);
  joins_ = shared.joins;
  cluster::ClusterLog::Settings settings;
  settings.store = writer_settings_;
  settings.settles = std::make_shared<const edits::SettleRules>(local::settle_rules(world));
  cluster::ClusterLog::Parts parts{*stream_, *database_, *state_, clock_, logger_, tell_feed()};
  parts.on_takes = [this] {
    if (EditIntake* const intake = waits_for_log_.load()) intake->resume();
  };
  parts.on_lost = std::move(shared.on_lost);
  shared_ = std::make_unique<cluster::ClusterLog>(std::move(parts), std::move(settings));
  log_ = shared_.get();
  shared_->start();
}

LocalLog::State WorldEdits::status() const {
  if (local_ != nullptr) return local_->status();
  cluster::ClusterLog::State status = shared_->status();
  return {status.head, status.waiting, std::move(status.read_only), false, {}, std::move(status.disk_wait)};
}

void WorldEdits::join(const terrain::World& world, ChunkSource& chunks, Metrics& metrics, bool settles) {
  const SignalBlocker blocked;  // for the log's threads
  if (shared_ == nullptr) {
    local_ = std::make_unique<LocalLog>(*database_, *state_, clock_, LocalLogSettings{writer_settings_, {}},
                                        tell_feed());
    log_ = local_.get();
  }
  EditIntake::Parts parts{
      chunks,
      *log_,
      [this](edits::EditorId id) { return state_->editor(id); },
      clock_,
      metrics,
      [this] { return shared_ != nullptr ? shared_->room_for_editor() : admit_editor(*state_, clock_); }};
  intake_ = std::make_unique<EditIntake>(std::move(parts), rules_of(world, placeables_, settles), logger_);
  waits_for_log_ = intake_.get();
}

void WorldEdits::start(RunPregen pregen) {
  const SignalBlocker blocked;
  feed_.start();
  intake_->start();
  auto socket = StoreSocket::open(
      database_->path(), {*database_, *log_, [this] { return status().read_only; }, std::move(pregen)},
      logger_);
  if (socket) {
    socket_ = *std::move(socket);
  } else {
    logger_->warn("{}", socket.error());
  }
}

void WorldEdits::stop() {
  socket_.reset();  // clients waiting there for the log get their answer
  if (intake_ != nullptr) intake_->stop();
  if (local_ != nullptr) local_->stop();
  if (shared_ != nullptr) shared_->stop();
}

}  // namespace talus::server
