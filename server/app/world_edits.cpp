#include "app/world_edits.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <talus/edits/materials.h>
#include <talus/terrain/extraction.h>

#include "threads/signals.h"

namespace talus::server {
namespace {

constexpr std::size_t kMostPlaceables = 65'000;

/// The world's loose materials, and what shows in place of them and is loose too.
edits::SettleRules settle_rules(const terrain::World& world) {
  static_assert(edits::SettleRule::kUnit == terrain::kSubvoxels);
  std::map<MaterialId, std::int32_t> rises;
  for (const terrain::LooseSpec& loose : world.loose()) {
    rises.emplace(loose.material, loose.c_fx);
    const auto* const shown = world.shown_by(loose.material);
    if (shown == nullptr) continue;
    for (const MaterialId id : shown->by_look) {
      const bool is_loose = world.materials()[to_integer(id)].kind == terrain::MaterialKind::eroded;
      if (is_loose) rises.emplace(id, loose.c_fx);
    }
  }
  edits::SettleRules rules;
  for (const auto& [material, rise] : rises) rules.push_back({material, rise});
  return rules;
}

/// All that the world names, air and water among them.
EditIntake::Rules rules_of(const terrain::World& world, const std::vector<terrain::Material>& placeables,
                           bool settles) {
  EditIntake::Rules rules{terrain::height_range(world), {}, nullptr};
  if (settles) rules.settles = std::make_shared<const edits::SettleRules>(settle_rules(world));
  for (const auto* const materials : {&world.materials(), &placeables}) {
    for (const terrain::Material& material : *materials) rules.materials.push_back(material.id);
  }
  std::ranges::sort(rules.materials);
  return rules;
}

}  // namespace

tl::expected<std::unique_ptr<WorldEdits>, std::string> WorldEdits::open(
    const std::filesystem::path& directory, const terrain::World& world, ContentHash store_id, Logger log) {
  const SignalsBlocked blocked;  // for RocksDB's threads
  EditDatabaseSettings settings;
  settings.path = directory;
  settings.fingerprint = world.fingerprint();
  settings.store_id = store_id;
  auto database = EditDatabase::open(settings);
  if (!database) return tl::unexpected{std::move(database.error())};
  if (const ContentHash now = (*database)->meta().store_id; now != store_id) {
    log->warn("data {}: the file acknowledged is gone, so edits may be lost; the store has a new id, {}",
              directory.string(), to_string(now));
  }
  auto state = EditState::open(**database, EditStateSettings{});
  if (!state) return tl::unexpected{std::move(state.error())};
  std::unique_ptr<WorldEdits> edits{new WorldEdits{*std::move(database), *std::move(state), log}};
  if (const auto bound = edits->bind_placeables(world); !bound) return tl::unexpected{bound.error()};
  return edits;
}

EditDatabase::Done WorldEdits::bind_placeables(const terrain::World& world) {
  std::map<std::string, MaterialId> generated;
  for (const terrain::Material& material : world.materials()) generated.emplace(material.name, material.id);
  if (auto named = database_->name_generated(generated); !named) return named;
  const std::map<std::string, MaterialId>& known = database_->materials();
  std::map<std::string, MaterialId> missing = known;
  for (const auto& [name, id] : generated) missing.erase(name);
  std::map<std::string, MaterialId> added;
  std::uint16_t next = kFirstBound;
  if (known.size() + world.placeables().size() > kMostPlaceables) {
    return tl::unexpected{fmt::format("data {}: the store has ids for {} more materials; the world names {}",
                                      database_->path().string(), kMostPlaceables - known.size(),
                                      world.placeables().size())};
  }
  for (const auto& [name, id] : known) {
    next = std::max(next, static_cast<std::uint16_t>(to_integer(id) + 1));
  }
  for (const terrain::Placeable& placeable : world.placeables()) {
    const auto bound = known.find(placeable.name);
    const MaterialId id = bound != known.end() ? bound->second : MaterialId{next++};
    if (bound == known.end()) added.emplace(placeable.name, id);
    missing.erase(placeable.name);
    placeables_.push_back({id, placeable.name, placeable.colour, placeable.kind});
  }
  if (!missing.empty()) {
    const auto uses = count_uses();
    if (!uses) return tl::unexpected{uses.error()};
    for (const auto& [name, id] : missing) {
      if (const auto count = uses->find(id); count != uses->end()) {
        return tl::unexpected{
            fmt::format("data {}: the world has no [[placeable]] \"{}\" any more, of which the store has {} "
                        "voxels; put it "
                        "back into the world's file",
                        database_->path().string(), name, count->second)};
      }
    }
  }
  return added.empty() ? EditDatabase::Done{} : database_->bind(added);
}

tl::expected<std::map<MaterialId, std::uint64_t>, std::string> WorldEdits::count_uses() const {
  std::set<ChunkKey> chunks;
  const auto scanned = database_->for_each_chunk([&](ChunkKey key, std::uint64_t) { chunks.insert(key); });
  if (!scanned) return tl::unexpected{scanned.error()};
  for (const ChunkKey key : state_->dirty_chunks()) chunks.insert(key);
  std::map<MaterialId, std::uint64_t> uses;
  for (const ChunkKey key : chunks) {
    if (key.lod != Lod{}) continue;
    const auto chunk = state_->load(key);
    if (!chunk) return tl::unexpected{chunk.error()};
    if (chunk->overrides == nullptr) continue;
    for (const Override& voxel : chunk->overrides->voxels()) ++uses[voxel.material];
  }
  return uses;
}

ChunkSource& WorldEdits::join(const terrain::World& world, ChunkSource& base, const Clock& clock,
                              Metrics& metrics, bool settles) {
  const SignalsBlocked blocked;  // for the log's
  chunks_ = std::make_unique<EditedChunks>(base, *state_, merged_, feed_, metrics);
  log_ =
      std::make_unique<LocalLog>(*database_, *state_, clock, LocalLogSettings{},
                                 [this](std::span<const ChunkChange> changes) { feed_.on_changed(changes); });
  EditIntake::Parts parts{base, *log_, [this](edits::EditorId id) { return state_->editor(id); }, clock,
                          metrics};
  intake_ = std::make_unique<EditIntake>(std::move(parts), rules_of(world, placeables_, settles), logger_);
  return *chunks_;
}

void WorldEdits::start(RunPregen pregen) {
  const SignalsBlocked blocked;
  feed_.start();
  intake_->start();
  auto socket = StoreSocket::open(
      database_->path(), {*database_, *log_, [this] { return log_->status().read_only; }, std::move(pregen)},
      logger_);
  if (socket) {
    socket_ = *std::move(socket);
  } else {
    logger_->warn("{}", socket.error());
  }
}

void WorldEdits::stop() {
  socket_.reset();  // who waits for the log there gets its answer
  if (intake_ != nullptr) intake_->stop();
  if (log_ != nullptr) log_->stop();
}

}  // namespace talus::server
