// A world's edits in one server: the database, the applied state, the log (this server's own or a shared
// one), and the intake that prepares edits for it.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/store/edit_database.h>
#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>

#include "chunks/change_feed.h"
#include "chunks/chunks.h"
#include "chunks/edited_land.h"
#include "cluster/cluster_log.h"
#include "cluster/log_stream.h"
#include "edits/edit_intake.h"
#include "edits/edit_state.h"
#include "edits/local_log.h"
#include "edits/store_socket/store_socket.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

/// The log that this server shares with others.
struct SharedLog {
  std::unique_ptr<LogStream> stream;  // null: the log is this server's own
  std::uint64_t joins = 0;            // checkpoints of peers loaded for the store
  /// Called if the store is lost to the cluster (cluster_log.h).
  std::function<void(cluster::StoreLoss, const std::string&)> on_lost = [](cluster::StoreLoss,
                                                                           const std::string&) {};
  /// Called if the disk lost entries that the log can supply again (edit_database.h).
  std::function<void(const std::string&)> on_lost_end = [](const std::string&) {};
};

class WorldEdits final : public EditedLand {
 public:
  /// Opens the store in `directory`, which a DataDirectory must have locked, and starts a shared log. If the
  /// world has new materials, waits until the log gives them ids. `clock` must outlive this. An error is one
  /// line.
  [[nodiscard]] static tl::expected<std::unique_ptr<WorldEdits>, std::string> open(
      const std::filesystem::path& directory, const terrain::World& world, ContentHash store_id,
      const Clock& clock, Logger log, const EditStateSettings& state_settings, store::HistoryLimits history,
      store::StoreMemory memory = {}, SharedLog shared = {});
  /// Differs from open()'s argument if the store had to become another.
  [[nodiscard]] ContentHash store_id() const { return store_id_; }
  ~WorldEdits() override { stop(); }
  WorldEdits(const WorldEdits&) = delete;
  WorldEdits& operator=(const WorldEdits&) = delete;

  [[nodiscard]] const EditState& state() const { return *state_; }
  [[nodiscard]] EditState& state() { return *state_; }
  /// Materials that the world names but does not generate, with the permanent ids that the store gave them.
  [[nodiscard]] const std::vector<terrain::Material>& placeables() const { return placeables_; }
  [[nodiscard]] Chunks::Edits of_chunks() { return {*state_, feed_}; }

  /// Connects the edits to the chunks; call once, before everything below. Arguments must outlive stop().
  /// `settles`: loose material slides.
  void join(const terrain::World& world, ChunkSource& chunks, Metrics& metrics, bool settles);
  [[nodiscard]] EditTaker& taker() { return *intake_; }
  /// Starts the threads; call once. `pregen` generates land for a command; may be empty.
  void start(RunPregen pregen = {});
  /// Stops accepting edits, and answers the accepted ones.
  void stop();
  [[nodiscard]] LocalLog::State status() const;
  /// The shared log; null if the log is this server's own.
  [[nodiscard]] const cluster::ClusterLog* shared() const { return shared_.get(); }
  /// As passed to open().
  [[nodiscard]] std::uint64_t joins() const { return joins_; }
  /// Number of edits that are not in the log yet.
  [[nodiscard]] std::size_t preparing() const { return intake_->waiting(); }

  /// See EditIntake.
  void limit_bases(std::size_t bytes) { intake_->limit_bases(bytes); }
  [[nodiscard]] std::size_t base_bytes() const { return intake_->base_bytes(); }

  /// Callable from any thread.
  [[nodiscard]] store::HistorySpan history() const { return database_->history(); }
  /// EditDatabase::memory_bytes(). Callable from any thread.
  [[nodiscard]] std::size_t store_bytes() const { return database_->memory_bytes(); }
  /// EditDatabase::checkpoint(). Callable from any thread.
  [[nodiscard]] store::EditDatabase::Status checkpoint(const std::filesystem::path& path) const {
    return database_->checkpoint(path);
  }

  // Valid after join().
  [[nodiscard]] std::uint64_t revision() const override { return state_->revision(); }
  [[nodiscard]] bool takes_edits() const override { return !status().read_only; }
  [[nodiscard]] std::uint64_t column_revision(ChunkKey key) const override {
    return state_->index().column_revision(key);
  }
  [[nodiscard]] ChunkRange edited_rows(ChunkKey key) const override { return state_->edited_rows(key); }
  [[nodiscard]] std::vector<EditedColumn> edited_columns(ChunkKey key) const override {
    return state_->index().edited_columns(key);
  }

 private:
  WorldEdits(std::unique_ptr<store::EditDatabase> database, std::unique_ptr<EditState> state,
             const Clock& clock, const Logger& log)
      : logger_{log},
        clock_{clock},
        database_{std::move(database)},
        store_id_{database_->meta().store_id},
        state_{std::move(state)},
        feed_{log} {}

  void start_shared_log(SharedLog shared, const terrain::World& world);
  [[nodiscard]] store::EditDatabase::Status name_placeables(const terrain::World& world, SharedLog shared);
  /// Called by either log after a batch.
  [[nodiscard]] StoreWriter::OnChanged tell_feed() {
    return [this](std::span<const ChunkChange> changes) { feed_.on_changed(changes); };
  }

  const Logger logger_;
  const Clock& clock_;
  std::vector<terrain::Material> placeables_;
  const std::unique_ptr<store::EditDatabase> database_;
  const ContentHash store_id_;  // a copy, because a shared log changes the database's other metadata
  const std::unique_ptr<EditState> state_;
  StoreWriterSettings writer_settings_;
  ChangeFeed feed_;
  std::unique_ptr<LogStream> stream_;
  std::uint64_t joins_ = 0;
  std::atomic<EditIntake*> waits_for_log_{nullptr};  // notified when a shared log accepts edits again
  std::unique_ptr<cluster::ClusterLog> shared_;      // exactly one of shared_ and local_ is set
  std::unique_ptr<LocalLog> local_;
  EditLog* log_ = nullptr;
  std::unique_ptr<EditIntake> intake_;
  std::unique_ptr<StoreSocket> socket_;  // null: it could not be created
};

}  // namespace talus::server
