// A store of edits that nobody writes: a checkpoint, a backup, or a data directory that the caller has
// locked. It is read as it lies there; no file changes.
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
  using Done = tl::expected<void, std::string>;

  /// `path` has the directory db. Verifies the log behind what chunks hold. An error is one line.
  [[nodiscard]] static tl::expected<std::unique_ptr<ReadOnlyStore>, std::string> open(
      const std::filesystem::path& path);
  ~ReadOnlyStore();

  [[nodiscard]] const StoreMeta& meta() const { return meta_; }
  [[nodiscard]] const std::map<std::string, MaterialId>& materials() const { return materials_; }
  [[nodiscard]] const std::deque<HistorySegment>& history() const { return history_; }
  [[nodiscard]] StoreReader reader() const;

  /// As of the last entry of the log; nothing where it was never edited. Any thread.
  [[nodiscard]] StoreReader::Result<std::optional<StoredChunk>> chunk(ChunkKey key) const;
  /// All chunks as of the last entry of the log, in the order of keys, that of level 0 first: by x, then z,
  /// then y. Until `visit` returns false.
  [[nodiscard]] Done for_each_chunk(const std::function<bool(ChunkKey, const StoredChunk&)>& visit) const;
  /// Those of level 0 alone.
  [[nodiscard]] Done for_each_base_chunk(
      const std::function<bool(ChunkCoord, const StoredChunk&)>& visit) const;

  /// The first entry of the log that is kept; one more than the last where none is.
  [[nodiscard]] std::uint64_t first_record() const;
  /// Of the log's entries that are kept, those that are not flushed yet among them.
  [[nodiscard]] std::uint64_t record_bytes() const;
  /// How many there are as of the last entry of the log. Reads all of them.
  [[nodiscard]] StoreReader::Result<std::size_t> count_editors() const;
  /// Reads every block of every file.
  [[nodiscard]] Done verify_files() const;
  /// Chunks that are stored, roughly, for progress.
  [[nodiscard]] std::uint64_t estimated_keys() const;

 private:
  explicit ReadOnlyStore(std::filesystem::path path);
  /// What records behind the flushed ones change, by key.
  [[nodiscard]] Done read_unflushed();

  std::filesystem::path path_;
  std::unique_ptr<rocksdb::DB> db_;
  StoreMeta meta_;
  std::map<std::string, MaterialId> materials_;
  std::deque<HistorySegment> history_;
  std::map<std::string, StoredChunk> unflushed_;
  std::uint64_t unflushed_bytes_ = 0;  // of their records
};

}  // namespace talus::store
