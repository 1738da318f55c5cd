#include "app/world_edits.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <talus/terrain/extraction.h>

namespace talus::server {
namespace {

/// All that the world names, air and water among them.
EditIntake::Rules rules_of(const terrain::World& world) {
  EditIntake::Rules rules{terrain::height_range(world), {}};
  for (const terrain::Material& material : world.materials()) rules.materials.push_back(material.id);
  std::ranges::sort(rules.materials);
  return rules;
}

}  // namespace

tl::expected<std::unique_ptr<WorldEdits>, std::string> WorldEdits::open(
    const std::filesystem::path& directory, ContentHash fingerprint, ContentHash store_id, Logger log) {
  EditDatabaseSettings settings;
  settings.path = directory;
  settings.fingerprint = fingerprint;
  settings.store_id = store_id;
  auto database = EditDatabase::open(settings);
  if (!database) return tl::unexpected{std::move(database.error())};
  auto state = EditState::open(**database, EditStateSettings{});
  if (!state) return tl::unexpected{std::move(state.error())};
  return std::unique_ptr<WorldEdits>{new WorldEdits{*std::move(database), *std::move(state), log}};
}

ChunkSource& WorldEdits::join(const terrain::World& world, ChunkSource& base, const Clock& clock,
                              Metrics& metrics) {
  chunks_ = std::make_unique<EditedChunks>(base, *state_, merged_, feed_, metrics);
  log_ =
      std::make_unique<LocalLog>(*database_, *state_, clock, LocalLogSettings{},
                                 [this](std::span<const ChunkChange> changes) { feed_.on_changed(changes); });
  EditIntake::Parts parts{base, *log_, [this](edits::EditorId id) { return state_->editor(id); },
                          [this] { return state_->revision(); }};
  intake_ = std::make_unique<EditIntake>(std::move(parts), rules_of(world), logger_);
  return *chunks_;
}

void WorldEdits::start() {
  feed_.start();
  intake_->start();
}

void WorldEdits::stop() {
  if (intake_ != nullptr) intake_->stop();
  if (log_ != nullptr) log_->stop();
}

}  // namespace talus::server
