// The edits of one world on disk: the log's records, and by them chunks and editors, which are written later
// and make the records history. FORMAT.md has every byte.
//
// One thread writes. Whatever a power cut leaves, the store opens with all that append() returned for, or
// says in one line what is lost.
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
class WriteBatch;
}  // namespace rocksdb

namespace talus::store {

/// What is flushed stays as history until there is more, or until it is older, by the log's time.
struct HistoryLimits {
  std::uint64_t bytes = std::uint64_t{1} << 30U;
  std::chrono::milliseconds age = std::chrono::days{30};
};

struct HistoryKept {
  std::uint64_t bytes = 0;
  std::int64_t since_ms = 0;  // from then on all of it, since 1970 by the log's time; 0: there is none
};

/// What RocksDB may hold in memory, but for the index and the filter of each open table.
struct StoreMemory {
  std::size_t write_buffer_bytes = std::size_t{32} << 20U;  // of which there are two at most
  std::size_t block_cache_bytes = std::size_t{8} << 20U;
  [[nodiscard]] std::size_t most() const { return 2 * write_buffer_bytes + block_cache_bytes; }
};

struct EditDatabaseSettings {
  std::filesystem::path path;  // a directory that a DataDirectory has locked
  ContentHash fingerprint;     // of the world
  ContentHash store_id;
  StoreMemory memory{};
  HistoryLimits history{};
  /// On a full disk RocksDB may abort the process where it opens.
  std::uint64_t free_bytes_to_open = std::uint64_t{64} << 20U;
  rocksdb::Env* env = nullptr;  // for tests; null: the system's. Outlives the database
  /// Tests alone set it to false: what is acknowledged then may be lost by a power cut.
  bool sync = true;
  /// The entries are in a log that others hold too: append() does not sync, sync() does, and what a power cut
  /// takes of the end is read there again.
  bool log_elsewhere = false;
  /// The disk has lost such an end while the database was open, in one line: what the process has of it is
  /// more than the store has, and the next open() reads it again. On recover()'s thread, each time.
  std::function<void(const std::string&)> on_lost_end{};
};

class EditDatabase {
 public:
  using Done = tl::expected<void, std::string>;  // an error is one line

  /// Makes the store where there is none. Refuses one of another world or store, of a newer format, a damaged
  /// one, and one that has less than was acknowledged. One without the file that says what was acknowledged
  /// is another store from now on: meta() and store.toml have a new id.
  [[nodiscard]] static tl::expected<std::unique_ptr<EditDatabase>, std::string> open(
      const EditDatabaseSettings& settings);
  ~EditDatabase();

  [[nodiscard]] const StoreMeta& meta() const { return meta_; }
  [[nodiscard]] const std::filesystem::path& path() const { return settings_.path; }

  /// After open(), in this order, before anything is written. Every checksum is verified.
  [[nodiscard]] Done for_each_chunk(const std::function<void(ChunkKey, std::uint64_t revision)>& visit) const;
  [[nodiscard]] Done for_each_editor(const std::function<void(edits::EditorId, StoredEditor&&)>& visit) const;
  /// The records behind meta().flushed, which neither chunks nor editors need hold: no position is missing,
  /// and each record's link is right. A false of `visit` is a record that does not fit.
  [[nodiscard]] Done replay(const std::function<bool(LogRecord&&)>& visit);

  /// Any thread. Nothing where the chunk was never flushed.
  [[nodiscard]] tl::expected<std::optional<StoredChunk>, std::string> chunk(ChunkKey key) const;

  /// History as far as it is kept, and what is not flushed, from `first` on, until `visit` returns false.
  /// Links are verified but for that of the first. On the thread that writes.
  [[nodiscard]] Done for_each_record(std::uint64_t first,
                                     const std::function<bool(LogRecord&&)>& visit) const;

  /// Any thread.
  [[nodiscard]] HistoryKept history() const { return {history_size_, history_since_ms_}; }

  /// Any thread. The database as of some moment during the call, with all that append() returned for before
  /// it, as a new directory `path`, whose parent exists: files that never change are linked, where it is of
  /// the same file system. An error leaves nothing.
  [[nodiscard]] Done checkpoint(const std::filesystem::path& path) const;

  /// While it lives the database's files stay where they are, so that another process may read and copy them
  /// as they lie there, and nothing is written for it: for where no checkpoint can be made. After an error of
  /// the disk the database is opened again when it has gone. Any thread, the one on which it ends as well.
  class HeldFiles;
  [[nodiscard]] std::unique_ptr<HeldFiles> hold_files() const;

  /// Writes all that the batch applied, at once and, but for a log elsewhere, synced; with it where the store
  /// stands in the stream from then on, and the ids that it has given to materials. After an error nobody
  /// knows whether it is on the disk: nothing but this batch may be appended until it succeeds, which does no
  /// harm where it was.
  [[nodiscard]] Done append(const edits::Batch& batch, const StreamPlace& place);
  [[nodiscard]] Done append(const edits::Batch& batch) { return append(batch, meta_.stream); }
  /// Of a log elsewhere: all that was appended is on the disk when it returns, and counts as acknowledged.
  [[nodiscard]] Done sync();
  [[nodiscard]] bool has_unsynced() const { return unsynced_; }
  [[nodiscard]] bool has_log_elsewhere() const { return settings_.log_elsewhere; }
  /// The same in three steps, so that another thread waits for the disk: what was written before begin_sync()
  /// is there once sync_log(), called after it, has returned, and end_sync() then counts it as acknowledged.
  struct Written {
    std::uint64_t position = 0;
    std::uint64_t link = 0;
  };
  [[nodiscard]] Written begin_sync();
  /// Any thread. recover() fails meanwhile.
  [[nodiscard]] Done sync_log() const;
  void end_sync(const Written& written);
  /// Nothing is applied, and the store stands there now, synced.
  [[nodiscard]] Done enter(const StreamPlace& place);

  /// Chunks and editors as they are now, in one write that is not synced: until mark_flushed() the log's
  /// records have them too.
  class Slice;
  [[nodiscard]] Done put(const Slice& slice);
  /// All chunks and editors as of `position`, that of a batch's last record, were put, and synced since:
  /// RocksDB's log is of several files, of which the newest may outlive a power cut that takes the end of the
  /// one before, so nothing may say that chunks were put before they are on the disk. What history need not
  /// keep goes.
  [[nodiscard]] Done mark_flushed(std::uint64_t position);
  /// Where what was put is not in the log's records any more: on the disk when it returns. Makes the next
  /// opening cheap.
  [[nodiscard]] Done settle();

  /// After an error of a write: whether writing may be tried again. Waits for no checkpoint and no
  /// sync_log(): while one is under way that is an error.
  [[nodiscard]] Done recover();

  [[nodiscard]] std::uint64_t free_bytes() const;

  /// What RocksDB has in memory: what was written and is in no table yet, blocks that were read, and the
  /// index and the filter of each open table. While the database is opened again, what it was when somebody
  /// asked last. Any thread; waits for nobody.
  [[nodiscard]] std::size_t memory_bytes() const;

  /// Which name has which id. An id is given once, for ever; rename() changes its name, and the old name,
  /// bound again, has another id. On the thread that writes.
  [[nodiscard]] const edits::MaterialIds& materials() const { return materials_; }
  /// Binds names that are not bound yet, synced. Refuses a name that has another id, and an id that has
  /// another name; then nothing is bound.
  [[nodiscard]] Done bind(const edits::MaterialIds& materials);
  /// Another name for a bound id, synced. Refuses what check_rename() does. Not where a cluster's log binds
  /// names.
  [[nodiscard]] Done rename(const std::string& from, const std::string& to);
  /// What the world calls the materials that it generates, in place of what it called them before: their ids,
  /// below kFirstBound, follow from its fingerprint, their names do not. Refuses a name that is bound.
  [[nodiscard]] Done name_generated(const edits::MaterialIds& materials);

 private:
  /// Of a batch that is not flushed yet.
  struct Unflushed {
    std::uint64_t position = 0;  // of its last record
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
  [[nodiscard]] Done open_database();
  [[nodiscard]] Done read_meta();
  [[nodiscard]] Done make_store();
  [[nodiscard]] Done check_meta() const;
  [[nodiscard]] bool has_acknowledged() const;
  [[nodiscard]] Done check_acknowledged();
  [[nodiscard]] Done become_another();
  [[nodiscard]] Done read_materials();
  [[nodiscard]] Done read_history();
  [[nodiscard]] Done drop_records_beyond();
  [[nodiscard]] Done write(rocksdb::WriteBatch& batch, bool sync);
  void put_material(const std::string& name, MaterialId id, rocksdb::WriteBatch& batch);
  void extend_history(const Unflushed& flushed, std::uint64_t first, rocksdb::WriteBatch& batch);
  void publish_history();

  EditDatabaseSettings settings_;
  // Both unique while the database is opened again: of those that read a chunk, and of those that copy all.
  mutable std::shared_mutex handle_;
  mutable std::shared_mutex copying_;
  std::unique_ptr<rocksdb::DB> db_;
  bool was_there_ = false;  // when it was opened
  bool unsynced_ = false;   // of a log elsewhere: since the last sync() something was appended
  std::optional<AcknowledgedFile> acknowledged_;
  StoreMeta meta_;
  std::deque<Unflushed> unflushed_;
  std::deque<HistorySegment> history_;
  std::uint64_t history_bytes_ = 0;
  std::atomic<std::uint64_t> history_size_ = 0;  // history_bytes_, for other threads
  std::atomic<std::int64_t> history_since_ms_ = 0;
  mutable std::atomic<std::size_t> memory_ = 0;  // the last figure of memory_bytes()
  edits::MaterialIds materials_;
  Bytes value_;    // of the thread that writes
  Bytes entries_;  // the same
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

/// Values to be written at once.
class EditDatabase::Slice {
 public:
  Slice();
  ~Slice();
  void put(ChunkKey key, std::uint64_t revision, std::span<const Override> voxels);
  /// As after the entry `position`.
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
