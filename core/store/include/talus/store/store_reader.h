// What a database of edits holds, read and verified: every checksum, every key, the order of the log's
// records. Says in one line what is damaged.
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

/// What one may do where a store is damaged; the end of such lines.
inline constexpr std::string_view kStoreLost = "restore a backup, or give --data another directory";

class StoreReader {
 public:
  using Done = tl::expected<void, std::string>;
  template <typename Value>
  using Result = tl::expected<Value, std::string>;

  /// `db` outlives this. `path` is named in errors.
  StoreReader(rocksdb::DB& db, const std::filesystem::path& path) : db_{db}, path_{path} {}

  /// Nothing where there is none.
  [[nodiscard]] Result<std::optional<StoreMeta>> meta() const;
  [[nodiscard]] Result<std::map<std::string, MaterialId>> materials() const;
  /// The oldest first; they follow each other, up to `flushed`.
  [[nodiscard]] Result<std::deque<HistorySegment>> history(std::uint64_t flushed) const;

  [[nodiscard]] Done for_each_chunk(const std::function<void(ChunkKey, std::uint64_t revision)>& visit) const;
  /// With their voxels, from the chunk `first` on by the order of keys, until `visit` returns false.
  [[nodiscard]] Done for_each_chunk_value(ChunkKey first,
                                          const std::function<bool(ChunkKey, StoredChunk&&)>& visit) const;
  [[nodiscard]] Done for_each_editor(const std::function<void(edits::EditorId, StoredEditor&&)>& visit) const;
  [[nodiscard]] Result<std::optional<StoredChunk>> chunk(ChunkKey key) const;

  /// The records behind meta.flushed up to its position: none is missing, and each link is right. A false of
  /// `visit` is a record that does not fit. Returns the bytes of their values.
  [[nodiscard]] Result<std::uint64_t> replay(const StoreMeta& meta,
                                             const std::function<bool(LogRecord&&)>& visit) const;
  /// From `first` on, or from the first that is kept, to meta's position, until `visit` returns false. From
  /// there on none is missing. Links are verified but for that of the first batch.
  [[nodiscard]] Done for_each_record(const StoreMeta& meta, std::uint64_t first,
                                     const std::function<bool(LogRecord&&)>& visit) const;

  [[nodiscard]] tl::unexpected<std::string> failure(std::string_view what) const;

 private:
  rocksdb::DB& db_;
  const std::filesystem::path& path_;
};

}  // namespace talus::store
