// A world's edits in one server, from the directory on disk to the sessions: database, applied state, log,
// and the intake that prepares edits for it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>

#include "chunks/chunk_overlay.h"
#include "chunks/chunk_source.h"
#include "chunks/edited_land.h"
#include "clock/clock.h"
#include "edits/change_feed.h"
#include "edits/edit_intake.h"
#include "edits/edit_state.h"
#include "edits/edited_chunks.h"
#include "edits/local_log.h"
#include "edits/merged_chunks.h"
#include "log/logger.h"
#include "metrics/metrics.h"
#include "store/edit_database.h"
#include "store_socket/store_socket.h"

namespace talus::server {

class WorldEdits final : public EditedLand {
 public:
  /// Opens what is stored in `directory`, which a DataDirectory has locked. An error is one line.
  [[nodiscard]] static tl::expected<std::unique_ptr<WorldEdits>, std::string> open(
      const std::filesystem::path& directory, const terrain::World& world, ContentHash store_id, Logger log);
  /// Another than open() was given where the store had to become another.
  [[nodiscard]] ContentHash store_id() const { return database_->meta().store_id; }
  ~WorldEdits() override { stop(); }
  WorldEdits(const WorldEdits&) = delete;
  WorldEdits& operator=(const WorldEdits&) = delete;

  [[nodiscard]] const EditState& state() const { return *state_; }
  /// What the world names beyond what it generates, by the ids that the store has given for ever.
  [[nodiscard]] const std::vector<terrain::Material>& placeables() const { return placeables_; }
  /// Through which generators answer.
  [[nodiscard]] ChunkOverlay& overlay() { return merged_; }

  /// The source of chunks with their edits, over those as generated; once, before all that follows. What is
  /// given outlives stop(), and what is returned this. `settles`: loose material slides.
  [[nodiscard]] ChunkSource& join(const terrain::World& world, ChunkSource& base, const Clock& clock,
                                  Metrics& metrics, bool settles);
  [[nodiscard]] EditTaker& taker() { return *intake_; }
  /// Starts the threads; once. `pregen`: by which a command has land made; empty: by none.
  void start(RunPregen pregen = {});
  /// Takes no more edits, and answers those that were taken.
  void stop();
  [[nodiscard]] LocalLog::Status status() const { return log_->status(); }
  /// Edits that are not in the log yet.
  [[nodiscard]] std::size_t preparing() const { return intake_->waiting(); }

  /// Any thread. EditDatabase::checkpoint().
  [[nodiscard]] EditDatabase::Done checkpoint(const std::filesystem::path& path) const {
    return database_->checkpoint(path);
  }

  // Once join() was called.
  [[nodiscard]] std::uint64_t revision() const override { return state_->revision(); }
  [[nodiscard]] bool takes_edits() const override { return !log_->status().read_only; }
  [[nodiscard]] std::uint64_t column_revision(ChunkKey key) const override {
    return state_->index().column_revision(key);
  }
  [[nodiscard]] ChunkRange edited_rows(ChunkKey key) const override { return state_->edited_rows(key); }
  [[nodiscard]] std::vector<EditedColumn> edited_columns(ChunkKey key) const override {
    return state_->index().edited_columns(key);
  }

 private:
  WorldEdits(std::unique_ptr<EditDatabase> database, std::unique_ptr<EditState> state, const Logger& log)
      : logger_{log},
        database_{std::move(database)},
        state_{std::move(state)},
        merged_{*state_, log},
        feed_{log} {}

  [[nodiscard]] EditDatabase::Done bind_placeables(const terrain::World& world);
  /// Voxels of each material that overrides have.
  [[nodiscard]] tl::expected<std::map<MaterialId, std::uint64_t>, std::string> count_uses() const;

  const Logger logger_;
  std::vector<terrain::Material> placeables_;
  const std::unique_ptr<EditDatabase> database_;
  const std::unique_ptr<EditState> state_;
  MergedChunks merged_;
  ChangeFeed feed_;
  std::unique_ptr<EditedChunks> chunks_;
  std::unique_ptr<LocalLog> log_;
  std::unique_ptr<EditIntake> intake_;
  std::unique_ptr<StoreSocket> socket_;  // null: it could not be made
};

}  // namespace talus::server
