// The edits of one world on disk: the log's records, from which chunks and editors are written later; flushed
// records become history. FORMAT.md specifies every byte.
//
// One thread writes. After a power cut the store opens with everything that append() returned for, or reports
// in one line what is lost.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <shared_mutex>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include <talus/edits/batch.h>
#include <talus/edits/materials.h>
#include <talus/store/acknowledged_file.h>
#include <talus/store/records.h>
#include <talus/store/store_reader.h>

namespace rocksdb {
class DB;
class Env;
class Status;
class WriteBatch;
}  // namespace rocksdb

namespace talus::store {

class WriteFailure;

/// Flushed records are kept as history within both limits; age is measured by the log's time.
struct HistoryLimits {
  std::uint64_t bytes = std::uint64_t{1} << 30U;
  std::chrono::milliseconds age = std::chrono::days{30};
};

struct HistorySpan {
  std::uint64_t bytes = 0;
  std::int64_t since_ms = 0;  // history is complete since then, in ms since 1970 by the log's time; 0: empty
};

/// Bounds RocksDB's memory, except the index and filter of each open table.
struct StoreMemory {
  std::size_t write_buffer_bytes = std::size_t{32} << 20U;  // there are at most two
  std::size_t block_cache_bytes = std::size_t{8} << 20U;
  [[nodiscard]] std::size_t max_bytes() const { return 2 * write_buffer_bytes + block_cache_bytes; }
};

struct EditDatabaseSettings {
  std::filesystem::path path;  // a directory locked by a DataDirectory
  ContentHash fingerprint;     // of the world
  ContentHash store_id;
  StoreMemory memory{};
  HistoryLimits history{};
  /// Free space required to open: on a full disk RocksDB may abort the process.
  std::uint64_t free_bytes_to_open = std::uint64_t{64} << 20U;
  rocksdb::Env* env = nullptr;  // for tests, must outlive the database; null: the system's
  /// False only in tests: a power cut may then lose acknowledged edits.
  bool sync = true;
  /// True if other servers hold the entries in a shared log: append() does not sync, sync() does, and entries
  /// lost by a power cut are read from the shared log again.
  bool log_elsewhere = false;
  /// Called on recover()'s thread, with a one-line reason, each time the disk lost the log's end: the process
  /// has more than the store then, and the next open() reads the lost entries again.
  std::function<void(const std::string&)> on_lost_end{};
};

class EditDatabase {
 public:
  using Status = tl::expected<void, std::string>;  // an error is one line

  /// Creates the store if it is missing. Rejects a store of another world or id, of a newer format, damaged,
  /// or with less than was acknowledged. A store without the file that records acknowledgements becomes
  /// another store: meta() and store.toml get a new id.
  [[nodiscard]] static tl::expected<std::unique_ptr<EditDatabase>, std::string> open(
      const EditDatabaseSettings& settings);
  ~EditDatabase();

  [[nodiscard]] const StoreMeta& meta() const { return meta_; }
  /// One line about the log's torn end that open() dropped; empty if the log was whole.
  [[nodiscard]] const std::string& dropped() const { return dropped_; }
  [[nodiscard]] const std::filesystem::path& path() const { return settings_.path; }

  /// Call after open(), in this order, before writing. Verifies every checksum.
  [[nodiscard]] Status for_each_chunk(
      const std::function<void(ChunkKey, std::uint64_t revision)>& visit) const;
  [[nodiscard]] Status for_each_editor(
      const std::function<void(edits::EditorId, StoredEditor&&)>& visit) const;
  /// Replays the records after meta().flushed, some of which chunks and editors may lack. Verifies that
  /// positions are consecutive and each link is right. `visit` returns false to reject a record.
  [[nodiscard]] Status replay(const std::function<bool(LogRecord&&)>& visit);

  /// Callable from any thread. nullopt if the chunk was never flushed.
  [[nodiscard]] tl::expected<std::optional<StoredChunk>, std::string> chunk(ChunkKey key) const;

  /// Visits the kept history and unflushed records from `first` on, until `visit` returns false. Verifies
  /// links, except that of the first batch. Only on the writing thread.
  [[nodiscard]] Status for_each_record(std::uint64_t first,
                                       const std::function<bool(LogRecord&&)>& visit) const;

  /// Callable from any thread.
  [[nodiscard]] HistorySpan history() const { return {history_size_, history_since_ms_}; }

  /// Writes a snapshot, taken at some moment during the call and including everything that append() had
  /// returned for, to the new directory `path`, whose parent must exist. Immutable files are linked if on the
  /// same file system. On error leaves nothing. Callable from any thread.
  [[nodiscard]] Status checkpoint(const std::filesystem::path& path) const;

  /// Keeps the database's files in place during its lifetime, so that another process can read and copy them;
  /// writes nothing. For when a checkpoint is impossible. After a disk error the database is reopened when
  /// this is destroyed. Created and destroyed on any thread.
  class HeldFiles;
  [[nodiscard]] std::unique_ptr<HeldFiles> hold_files() const;

  /// Writes everything that the batch applied, atomically and synced (unless log_elsewhere), with the store's
  /// place in the stream and the ids given to materials. After an error the outcome is unknown: only this
  /// batch may be appended until it succeeds; repeating it is harmless.
  [[nodiscard]] Status append(const edits::Batch& batch, const StreamPlace& place);
  [[nodiscard]] Status append(const edits::Batch& batch) { return append(batch, meta_.stream); }
  /// For log_elsewhere: syncs everything appended and counts it as acknowledged.
  [[nodiscard]] Status sync();
  [[nodiscard]] bool has_unsynced() const { return unsynced_; }
  [[nodiscard]] bool has_log_elsewhere() const { return settings_.log_elsewhere; }
  /// sync() in three steps, so that another thread can wait for the disk: data written before begin_sync() is
  /// on the disk once sync_log(), called after it, returns; end_sync() then counts it as acknowledged.
  struct SyncPoint {
    std::uint64_t position = 0;
    std::uint64_t link = 0;
  };
  [[nodiscard]] SyncPoint begin_sync();
  /// Callable from any thread. recover() fails meanwhile.
  [[nodiscard]] Status sync_log() const;
  void end_sync(const SyncPoint& written);
  /// Records the store's place in the stream, synced, without applying anything.
  [[nodiscard]] Status enter(const StreamPlace& place);

  /// Writes current chunks and editors atomically, without a sync: until mark_flushed() the log's records
  /// contain them too.
  class Slice;
  [[nodiscard]] Status put(const Slice& slice);
  /// Declares that all chunks and editors as of `position`, a batch's last record, were put and then synced.
  /// The sync is required because RocksDB's log has several files, and the newest may survive a power cut
  /// that truncates the one before: a mark must never survive without its chunks. Drops history beyond the
  /// limits.
  [[nodiscard]] Status mark_flushed(std::uint64_t position);
  /// Syncs and flushes data that the log's records no longer contain. Makes the next open() cheap.
  [[nodiscard]] Status settle();

  /// Reopens the database after a write error, so that writing can be retried. Never waits: fails while a
  /// checkpoint or sync_log() runs. Always fails once damage() is not empty.
  [[nodiscard]] Status recover();

  /// One line that names a damaged table, what is lost and what helps; empty unless a write met one. From
  /// then on every write fails; reads of undamaged data go on.
  [[nodiscard]] const std::string& damage() const { return damage_; }

  [[nodiscard]] std::uint64_t free_bytes() const;

  /// RocksDB's memory: unflushed writes, cached blocks, and the index and filter of each open table. While
  /// the database is reopened, returns the previous figure. Callable from any thread; never waits.
  [[nodiscard]] std::size_t memory_bytes() const;

  /// Material ids by name. An id is given once, for ever; rename() changes its name, and the old name, bound
  /// again, gets another id. Only on the writing thread.
  [[nodiscard]] const edits::MaterialIds& materials() const { return materials_; }
  /// Binds unbound names, synced. Rejects a name with another id, and an id with another name; then nothing
  /// is bound.
  [[nodiscard]] Status bind(const edits::MaterialIds& materials);
  /// Renames a bound id, synced. Rejects what check_rename() rejects. Not allowed if a cluster's log binds
  /// names.
  [[nodiscard]] Status rename(const std::string& from, const std::string& to);
  /// Replaces the names of the materials that the world generates: their ids, below kFirstBound, follow from
  /// its fingerprint, their names do not. Rejects a name that is bound.
  [[nodiscard]] Status name_generated(const edits::MaterialIds& materials);

 private:
  /// A batch that is not flushed yet.
  struct UnflushedBatch {
    std::uint64_t position = 0;  // its last record's
    std::uint64_t link = 0;
    std::uint64_t bytes = 0;
    std::int64_t time_ms = 0;
  };

  explicit EditDatabase(const EditDatabaseSettings& settings);
  [[nodiscard]] rocksdb::Env& env() const;
  [[nodiscard]] StoreReader reader() const;
  [[nodiscard]] std::string acknowledged_path() const { return (settings_.path / "acknowledged").string(); }
  [[nodiscard]] std::string database_path() const { return (settings_.path / "db").string(); }
  [[nodiscard]] tl::unexpected<std::string> failure(std::string_view what) const;
  [[nodiscard]] Status open_database();
  [[nodiscard]] Status read_meta();
  [[nodiscard]] Status make_store();
  [[nodiscard]] Status check_meta() const;
  [[nodiscard]] bool has_acknowledged() const;
  [[nodiscard]] Status check_acknowledged();
  [[nodiscard]] Status become_another();
  [[nodiscard]] Status read_materials();
  [[nodiscard]] Status read_history();
  [[nodiscard]] Status drop_records_beyond();
  [[nodiscard]] Status write(rocksdb::WriteBatch& batch, bool sync);
  /// Rejects the result of a write or sync, and all after it, once one failed or the store is closed.
  [[nodiscard]] Status check_written(const rocksdb::Status& status) const;
  void find_damage(const rocksdb::Status& status);
  void put_material(const std::string& name, MaterialId id, rocksdb::WriteBatch& batch);
  void extend_history(const UnflushedBatch& flushed, std::uint64_t first, rocksdb::WriteBatch& batch);
  void publish_history();

  EditDatabaseSettings settings_;
  // Locked exclusively to reopen the database: `handle_` by readers of a chunk, `copying_` by copies of all.
  mutable std::shared_mutex handle_;
  mutable std::shared_mutex copying_;
  std::shared_ptr<const void> rocks_parts_;  // db_ refers to them
  std::unique_ptr<rocksdb::DB> db_;
  std::shared_ptr<WriteFailure> write_failure_;  // of db_
  std::string dropped_;
  std::string damage_;
  bool was_there_ = false;  // the database existed when it was opened
  bool unsynced_ = false;   // for log_elsewhere: something was appended since the last sync()
  std::optional<AcknowledgedFile> acknowledged_;
  StoreMeta meta_;
  std::deque<UnflushedBatch> unflushed_;
  std::deque<HistorySegment> history_;
  std::uint64_t history_bytes_ = 0;
  std::atomic<std::uint64_t> history_size_ = 0;  // history_bytes_, for other threads
  std::atomic<std::int64_t> history_since_ms_ = 0;
  mutable std::atomic<std::size_t> memory_ = 0;  // the last result of memory_bytes()
  edits::MaterialIds materials_;
  Bytes value_;    // used by the writing thread
  Bytes entries_;  // used by the writing thread
};

class EditDatabase::HeldFiles {
 public:
  explicit HeldFiles(const EditDatabase& database);
  ~HeldFiles();
  HeldFiles(const HeldFiles&) = delete;
  HeldFiles& operator=(const HeldFiles&) = delete;

 private:
  const EditDatabase& database_;
  const std::shared_lock<std::shared_mutex> stays_open_;
  bool held_ = false;
};

/// Values that are written atomically.
class EditDatabase::Slice {
 public:
  Slice();
  ~Slice();
  void put(ChunkKey key, std::uint64_t revision, std::span<const Override> voxels);
  /// The editor's state after the entry `position`.
  void put(edits::EditorId id, std::uint64_t position, const edits::Editor& editor);
  void erase(edits::EditorId id);
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  friend class EditDatabase;
  std::unique_ptr<rocksdb::WriteBatch> batch_;
  std::size_t count_ = 0;
  Bytes value_;
};

}  // namespace talus::store
