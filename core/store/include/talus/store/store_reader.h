// Reads a database of edits and verifies every checksum, every key, and the order of the log's records.
// Damage is reported in one line.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include <talus/store/keys.h>
#include <talus/store/log_records.h>
#include <talus/store/records.h>

namespace rocksdb {
class DB;
}

namespace talus::store {

/// Remedy for a damaged store; ends such error lines.
inline constexpr std::string_view kStoreLost = "restore a backup, or give --data another directory";

class StoreReader {
 public:
  using Status = tl::expected<void, std::string>;
  template <typename Value>
  using Result = tl::expected<Value, std::string>;

  /// `db` must outlive this. `path` appears in errors.
  StoreReader(rocksdb::DB& db, const std::filesystem::path& path) : db_{db}, path_{path} {}

  /// nullopt if the value is missing.
  [[nodiscard]] Result<std::optional<StoreMeta>> meta() const;
  [[nodiscard]] Result<std::map<std::string, MaterialId>> materials() const;
  /// Oldest first; consecutive up to `flushed`.
  [[nodiscard]] Result<std::deque<HistorySegment>> history(std::uint64_t flushed) const;

  [[nodiscard]] Status for_each_chunk(
      const std::function<void(ChunkKey, std::uint64_t revision)>& visit) const;
  /// Visits chunks with their voxels in key order from the chunk `first` on, until `visit` returns false.
  [[nodiscard]] Status for_each_chunk_value(ChunkKey first,
                                            const std::function<bool(ChunkKey, StoredChunk&&)>& visit) const;
  [[nodiscard]] Status for_each_editor(
      const std::function<void(edits::EditorId, StoredEditor&&)>& visit) const;
  [[nodiscard]] Result<std::optional<StoredChunk>> chunk(ChunkKey key) const;

  /// Replays the records after meta.flushed up to meta's position; verifies that none is missing and each
  /// link is right. `visit` returns false to reject a record. Returns the bytes of the values.
  [[nodiscard]] Result<std::uint64_t> replay(const StoreMeta& meta,
                                             const std::function<bool(LogRecord&&)>& visit) const;
  /// Visits records from `first`, or from the first kept, to meta's position, until `visit` returns false.
  /// Verifies that none is missing, and all links except that of the first batch.
  [[nodiscard]] Status for_each_record(const StoreMeta& meta, std::uint64_t first,
                                       const std::function<bool(LogRecord&&)>& visit) const;

  [[nodiscard]] tl::unexpected<std::string> failure(std::string_view what) const;

 private:
  rocksdb::DB& db_;
  const std::filesystem::path& path_;
};

}  // namespace talus::store
