// A store of edits without a writer: a checkpoint, a backup, or a data directory that the caller has locked.
// Changes no file.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/records.h>
#include <talus/store/store_reader.h>

namespace talus::store {

class ReadOnlyStore {
 public:
  using Status = tl::expected<void, std::string>;

  /// `path` contains the directory db. Verifies the log after meta.flushed. An error is one line.
  [[nodiscard]] static tl::expected<std::unique_ptr<ReadOnlyStore>, std::string> open(
      const std::filesystem::path& path);
  ~ReadOnlyStore();
  /// Returns true if files of the database in `path` are damaged or missing. Reads every block of every file.
  [[nodiscard]] static bool is_damaged(const std::filesystem::path& path);

  [[nodiscard]] const StoreMeta& meta() const { return meta_; }
  /// One line about the log's torn end, which is left out; empty if the log is whole.
  [[nodiscard]] const std::string& dropped() const { return dropped_; }
  [[nodiscard]] const std::map<std::string, MaterialId>& materials() const { return materials_; }
  [[nodiscard]] const std::deque<HistorySegment>& history() const { return history_; }
  [[nodiscard]] StoreReader reader() const;

  /// As of the last entry of the log; nullopt if never edited. Callable from any thread.
  [[nodiscard]] StoreReader::Result<std::optional<StoredChunk>> chunk(ChunkKey key) const;
  /// Visits all chunks as of the last entry of the log in key order (level 0 first, by x, then z, then y)
  /// until `visit` returns false.
  [[nodiscard]] Status for_each_chunk(const std::function<bool(ChunkKey, const StoredChunk&)>& visit) const;
  /// Visits chunks of level 0 only.
  [[nodiscard]] Status for_each_base_chunk(
      const std::function<bool(ChunkCoord, const StoredChunk&)>& visit) const;

  /// Position of the first kept entry of the log; one past the last if none is kept.
  [[nodiscard]] std::uint64_t first_record() const;
  /// Bytes of the kept log entries, including unflushed ones.
  [[nodiscard]] std::uint64_t record_bytes() const;
  /// Number of editors as of the last entry of the log. Reads all of them.
  [[nodiscard]] StoreReader::Result<std::size_t> count_editors() const;
  /// Reads every block of every file.
  [[nodiscard]] Status verify_files() const;
  /// Approximate number of stored chunks, for progress reports.
  [[nodiscard]] std::uint64_t estimated_keys() const;

 private:
  explicit ReadOnlyStore(std::filesystem::path path);
  /// Applies the unflushed records to the chunks, by key.
  [[nodiscard]] Status read_unflushed();

  std::filesystem::path path_;
  std::shared_ptr<const void> rocks_parts_;  // db_ refers to them
  std::unique_ptr<rocksdb::DB> db_;
  std::string dropped_;
  StoreMeta meta_;
  std::map<std::string, MaterialId> materials_;
  std::deque<HistorySegment> history_;
  std::map<std::string, StoredChunk> unflushed_;
  std::uint64_t unflushed_bytes_ = 0;  // size of the unflushed records
};

}  // namespace talus::store
