// The applied state of one server: which chunks have edits, their overrides, who edits. The log's thread
// changes it; everybody reads.
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
  std::size_t cache_bytes = std::size_t{64} << 20U;   // of overrides that are stored too
  std::size_t recent_bytes = std::size_t{8} << 20U;   // of changes remembered voxel by voxel
  std::size_t index_bytes = std::size_t{512} << 20U;  // beyond it no further chunk may be edited
  std::size_t dirty_bytes = std::size_t{32} << 20U;   // of overrides that are not stored: they are flushed
  /// Beyond it nobody new may edit. All that a world may have need less.
  std::size_t editor_bytes = std::size_t{192} << 20U;
  bool operator==(const EditStateSettings&) const = default;
};

class EditState final : public AppliedEdits {
 public:
  /// The most of an editor that has never edited, and of one that has, as malloc serves it: with a subject of
  /// 256 bytes, all the results that are kept, and its place in three orders.
  static constexpr std::size_t kNewEditorBytes = 640;
  static constexpr std::size_t kUsedEditorBytes = 2'688;

  /// What `database` holds, which is newly opened and outlives this. An error is one line.
  [[nodiscard]] static tl::expected<std::unique_ptr<EditState>, std::string> open(
      store::EditDatabase& database, const EditStateSettings& settings);

  // Any thread.
  [[nodiscard]] std::uint64_t revision(ChunkKey key) const override { return index_.revision(key); }
  [[nodiscard]] ChunkRange edited_rows(ChunkKey key) const override { return index_.rows(key); }
  [[nodiscard]] tl::expected<EditedChunk, std::string> load(ChunkKey key) const override;
  [[nodiscard]] std::optional<Changes> changes_since(ChunkKey key, std::uint64_t since,
                                                     std::size_t most) const override;
  /// Of the whole state.
  [[nodiscard]] std::uint64_t revision() const { return revision_.load(std::memory_order_acquire); }
  [[nodiscard]] std::optional<edits::Editor> editor(edits::EditorId id) const;
  [[nodiscard]] std::size_t editor_count() const;
  /// Memory that editors may come to take: those that have edited with all the results that are kept of them.
  [[nodiscard]] std::size_t editor_bytes() const;
  /// Whether there is no place for further editors.
  [[nodiscard]] bool has_all_editors() const { return editor_bytes() >= settings_.editor_bytes; }
  /// Whether the next Attach that is applied at that time, since 1970, forgets one of them.
  [[nodiscard]] bool any_editor_idle_at(std::int64_t time_ms) const;
  [[nodiscard]] std::size_t editor_limit() const { return settings_.editor_bytes; }
  /// Whether the index has no place for further chunks.
  [[nodiscard]] bool is_full() const { return index_.bytes() >= settings_.index_bytes; }
  [[nodiscard]] std::size_t index_limit() const { return settings_.index_bytes; }
  [[nodiscard]] const ChunkIndex& index() const { return index_; }
  /// Memory held, roughly, but for the cache.
  [[nodiscard]] std::size_t bytes() const {
    return index_.bytes() + settings_.recent_bytes + dirty_bytes() + editor_bytes();
  }
  /// Of overrides that differ from the database's.
  [[nodiscard]] std::size_t dirty_bytes() const { return dirty_bytes_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::size_t cache_bytes() const { return cache_.bytes(); }
  /// The most that the cache may have.
  [[nodiscard]] std::size_t cache_limit() const { return settings_.cache_bytes; }
  /// The cache may have so much of that from now on: call fit_cache() until all fits.
  void set_cache_capacity(std::size_t bytes) { cache_.set_capacity(std::min(bytes, settings_.cache_bytes)); }
  /// Evicts a little. Whether all fits now.
  [[nodiscard]] bool fit_cache();

  // The log's thread alone, from here on.
  [[nodiscard]] const edits::Head& head() const { return head_; }
  [[nodiscard]] const edits::Editors& editors() const { return editors_; }

  /// What a batch reads. The overrides of a chunk that the disk did not give are missing: then error() says
  /// so, and the batch must be dropped.
  class Reading;

  /// Makes a batch of this very state, which is stored, the state. Returns each chunk that it changed once.
  std::vector<ChunkChange> commit(edits::Batch&& batch);

  // What differs from the database's chunks and editors.
  [[nodiscard]] std::vector<ChunkKey> dirty_chunks() const;
  [[nodiscard]] std::vector<edits::EditorId> take_dirty_editors();
  void put_dirty_editors(std::span<const edits::EditorId> ids) {
    dirty_editors_.insert(ids.begin(), ids.end());
  }
  /// Null where the chunk is not dirty.
  [[nodiscard]] const EditedChunk* dirty(ChunkKey key) const;
  /// The database has the chunk as of `revision`, whatever happens: from now on it is read there.
  void mark_clean(ChunkKey key, std::uint64_t revision);

 private:
  EditState(store::EditDatabase& database, const EditStateSettings& settings);
  [[nodiscard]] store::EditDatabase::Done replay();

  struct Dirty {
    EditedChunk chunk;
    /// Others may read these overrides: they say so through share(), under the shared lock.
    bool is_shared = false;
    void share() { std::atomic_ref{is_shared}.store(true, std::memory_order_relaxed); }  // the lock orders it
  };
  void put_dirty(Dirty& held, EditedChunk chunk);
  /// Makes the overrides those of the batch; `changed` has each of its chunks.
  void write_overrides(const std::unordered_map<ChunkKey, edits::StagedChunk>& staged,
                       std::span<const ChunkChange> changed);
  /// Whether the chunk's overrides may be written where they are.
  [[nodiscard]] static bool is_own(Dirty& held);
  /// Writes there; under the lock.
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

class EditState::Reading final : public edits::OverrideSource {
 public:
  explicit Reading(const EditState& state) : state_{state} {}
  [[nodiscard]] const edits::ChunkOverrides* find(ChunkKey chunk) const override;
  [[nodiscard]] const std::optional<std::string>& error() const { return error_; }
  /// The first of the chunks that cannot be read, in one line, or nothing. error() stays what it was.
  [[nodiscard]] std::optional<std::string> fault_of(std::span<const ChunkKey> chunks) const;

 private:
  struct Held {
    std::shared_ptr<const edits::ChunkOverrides> overrides;
    std::optional<std::string> fault;  // it cannot be read
  };
  [[nodiscard]] const Held& held(ChunkKey chunk) const;

  const EditState& state_;
  mutable std::unordered_map<ChunkKey, Held> held_;
  mutable std::optional<std::string> error_;
};

}  // namespace talus::server
