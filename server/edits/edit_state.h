// The applied state of one server: edited chunks, their overrides, and editors. The log's thread writes it;
// any thread reads it.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <shared_mutex>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/batch.h>
#include <talus/store/edit_database.h>

#include "chunks/applied_edits.h"
#include "chunks/cache/flat_map.h"
#include "chunks/cache/sharded_cache.h"
#include "edits/chunk_index.h"
#include "edits/recent_changes.h"

namespace talus::server {

struct EditStateSettings {
  std::size_t cache_bytes = std::size_t{64} << 20U;   // stored overrides
  std::size_t recent_bytes = std::size_t{8} << 20U;   // changes remembered voxel by voxel
  std::size_t index_bytes = std::size_t{512} << 20U;  // at this size new chunks cannot be edited
  std::size_t dirty_bytes = std::size_t{32} << 20U;   // overrides that are not stored: flushed beyond it
  /// At this size no editor is created. The maximum number of editors of a world needs less.
  std::size_t editor_bytes = std::size_t{192} << 20U;
  bool operator==(const EditStateSettings&) const = default;
};

class EditState final : public AppliedEdits {
 public:
  /// Maximum memory of an editor that has never edited, and of one that has, as malloc serves it: with a
  /// subject of 256 bytes, all kept results, and its place in three orders.
  static constexpr std::size_t kNewEditorBytes = 640;
  static constexpr std::size_t kUsedEditorBytes = 2'688;

  /// Reads the state from `database`, which is newly opened and outlives this. An error is one line.
  [[nodiscard]] static tl::expected<std::unique_ptr<EditState>, std::string> open(
      store::EditDatabase& database, const EditStateSettings& settings);

  // Any thread.
  [[nodiscard]] std::uint64_t revision(ChunkKey key) const override { return index_.revision(key); }
  [[nodiscard]] ChunkRange edited_rows(ChunkKey key) const override { return index_.rows(key); }
  void edited_chunks(const LevelBox& box, const ColumnFilter& wanted,
                     std::vector<ChunkKey>& found) const override {
    index_.edited_chunks(box, wanted, found);
  }
  [[nodiscard]] tl::expected<EditedChunk, std::string> load(ChunkKey key) const override;
  [[nodiscard]] std::optional<Changes> changes_since(ChunkKey key, std::uint64_t since,
                                                     std::size_t max_voxels) const override;
  /// The revision of the whole state.
  [[nodiscard]] std::uint64_t revision() const { return revision_.load(std::memory_order_acquire); }
  [[nodiscard]] std::optional<edits::Editor> editor(edits::EditorId id) const;
  [[nodiscard]] std::size_t editor_count() const;
  /// Memory that the editors may grow to: counts each that has edited with the maximum of kept results.
  [[nodiscard]] std::size_t editor_bytes() const;
  /// True if the editor table is full.
  [[nodiscard]] bool has_all_editors() const { return editor_bytes() >= settings_.editor_bytes; }
  /// True if an Attach applied at that time, since 1970, would remove an idle editor.
  [[nodiscard]] bool any_editor_idle_at(std::int64_t time_ms) const;
  [[nodiscard]] std::size_t editor_limit() const { return settings_.editor_bytes; }
  /// True if the index of edited chunks is full.
  [[nodiscard]] bool is_full() const { return index_.bytes() >= settings_.index_bytes; }
  [[nodiscard]] std::size_t index_limit() const { return settings_.index_bytes; }
  [[nodiscard]] const ChunkIndex& index() const { return index_; }
  /// Approximate memory, without the cache.
  [[nodiscard]] std::size_t bytes() const {
    return index_.bytes() + settings_.recent_bytes + dirty_bytes() + editor_bytes();
  }
  /// Memory of overrides that differ from the database.
  [[nodiscard]] std::size_t dirty_bytes() const { return dirty_bytes_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::size_t cache_bytes() const { return cache_.bytes(); }
  /// Maximum capacity of the cache.
  [[nodiscard]] std::size_t cache_limit() const { return settings_.cache_bytes; }
  /// Sets the capacity, up to cache_limit(): call fit_cache() until it returns true.
  void set_cache_capacity(std::size_t bytes) { cache_.set_capacity(std::min(bytes, settings_.cache_bytes)); }
  /// Evicts a little. Returns true if the cache fits now.
  [[nodiscard]] bool fit_cache();

  // From here on for the log's thread only.
  [[nodiscard]] const edits::Head& head() const { return head_; }
  [[nodiscard]] const edits::Editors& editors() const { return editors_; }

  /// The source that a batch reads. Overrides of a chunk that cannot be read from the disk are missing: then
  /// error() is set, and the batch must be dropped.
  class Reader;

  /// Makes a stored batch of this state the state. Returns each changed chunk once.
  std::vector<ChunkChange> commit(edits::Batch&& batch);

  // Chunks and editors that differ from the database.
  [[nodiscard]] std::vector<ChunkKey> dirty_chunks() const;
  [[nodiscard]] std::vector<edits::EditorId> take_dirty_editors();
  void put_dirty_editors(std::span<const edits::EditorId> ids) {
    dirty_editors_.insert(ids.begin(), ids.end());
  }
  /// Null if the chunk is not dirty.
  [[nodiscard]] const EditedChunk* dirty(ChunkKey key) const;
  /// The database durably has the chunk as of `revision`: from now on it is read there.
  void mark_clean(ChunkKey key, std::uint64_t revision);

 private:
  EditState(store::EditDatabase& database, const EditStateSettings& settings);
  [[nodiscard]] store::EditDatabase::Status replay();

  struct Dirty {
    EditedChunk chunk;
    /// Other threads may read these overrides: they call share(), under the shared lock.
    bool is_shared = false;
    void share() { std::atomic_ref{is_shared}.store(true, std::memory_order_relaxed); }  // the lock orders it
  };
  void put_dirty(Dirty& held, EditedChunk chunk);
  /// Replaces overrides by the batch's; `changed` has each of its chunks.
  void write_overrides(const std::unordered_map<ChunkKey, edits::StagedChunk>& staged,
                       std::span<const ChunkChange> changed);
  /// True if the chunk's overrides may be written in place.
  [[nodiscard]] static bool is_own(Dirty& held);
  /// Writes them in place; call it under the lock.
  void write_in_place(Dirty& held, const edits::StagedChunk& staged, std::uint64_t revision);

  store::EditDatabase& database_;
  EditStateSettings settings_;
  ChunkIndex index_;
  RecentChanges recent_;
  mutable ShardedCache<ChunkKey, EditedChunk> cache_;
  mutable std::shared_mutex dirty_mutex_;
  mutable FlatMap<ChunkKey, Dirty> dirty_;   // the log's thread reads it without the lock
  std::atomic<std::size_t> dirty_bytes_{0};  // the log's thread changes it
  edits::Head head_;
  std::atomic<std::uint64_t> revision_{0};  // the head's
  mutable std::shared_mutex editors_mutex_;
  edits::Editors editors_;  // the log's thread reads it without the lock
  std::unordered_set<edits::EditorId> dirty_editors_;
};

class EditState::Reader final : public edits::OverrideSource {
 public:
  explicit Reader(const EditState& state) : state_{state} {}
  [[nodiscard]] const edits::ChunkOverrides* find(ChunkKey chunk) const override;
  [[nodiscard]] const std::optional<std::string>& error() const { return error_; }
  /// Why the first of the chunks cannot be read, in one line, or nullopt. Does not change error().
  [[nodiscard]] std::optional<std::string> fault_of(std::span<const ChunkKey> chunks) const;

 private:
  struct HeldOverrides {
    std::shared_ptr<const edits::ChunkOverrides> overrides;
    std::optional<std::string> fault;  // why it cannot be read
  };
  [[nodiscard]] const HeldOverrides& held(ChunkKey chunk) const;

  const EditState& state_;
  mutable std::unordered_map<ChunkKey, HeldOverrides> held_;
  mutable std::optional<std::string> error_;
};

}  // namespace talus::server
