// A cache of generated columns of chunks on disk: expensive columns are read again after a restart, or after
// memory has evicted them. Lost or damaged columns are regenerated, the oldest are evicted first, and only
// readers wait for the disk. Callable from any thread.
//
// docs/decisions/07-columns-on-disk.md derives which columns are worth it from a table of their costs.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/voxel/content_hash.h>

#include "chunks/column_cache/column_record.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/instruments.h"

namespace rocksdb {
class DB;
}  // namespace rocksdb

namespace talus::server {

struct ColumnCacheSettings {
  std::filesystem::path path;  // its own directory, which it creates, and clears if necessary
  ContentHash fingerprint;     // the world's
  std::uint64_t bytes = 0;     // approximate size on disk
  std::size_t memory_bytes = std::size_t{16} << 20U;  // for unwritten columns and for read blocks
  /// With less free disk space no columns are stored: edits need it more.
  std::uint64_t free_bytes = std::uint64_t{1} << 30U;
};

class ColumnCache {
 public:
  /// Minimum cost of a column worth storing: 1.5 times a read of an otherwise idle disk.
  static constexpr std::chrono::microseconds kWorthKeeping{150};

  /// Starts empty if the directory has columns of another world or format, or is damaged. The error, one
  /// line, means that the directory cannot be written. `clock` outlives this.
  [[nodiscard]] static tl::expected<std::unique_ptr<ColumnCache>, std::string> open(
      const ColumnCacheSettings& settings, Logger log, const Clock& clock);
  /// Writes unwritten columns.
  ~ColumnCache();
  ColumnCache(const ColumnCache&) = delete;
  ColumnCache& operator=(const ColumnCache&) = delete;

  /// Returns true if a column that costs this much to generate should be put().
  [[nodiscard]] bool worth(std::chrono::nanoseconds cost) const;

  /// Reads the disk. `column` must be a column_of().
  [[nodiscard]] std::optional<ColumnRecord> find(ChunkKey column);

  /// Replaces the stored column. Does not wait for disk writes: if the disk is behind, the column is not
  /// stored.
  void put(ChunkKey column, const ColumnRecord& record);

  /// Writes all columns that were put to disk, except for failures of the disk.
  void flush();

  struct State {
    std::uint64_t found = 0;  // by find()
    std::uint64_t missing = 0;
    std::uint64_t kept = 0;        // by put()
    std::uint64_t lost = 0;        // damaged, or not stored because the disk was behind, full or failing
    std::uint64_t bytes = 0;       // on disk
    std::size_t memory_bytes = 0;  // RocksDB's
  };
  [[nodiscard]] State status() const;

 private:
  ColumnCache(const ColumnCacheSettings& settings, Logger log, const Clock& clock);
  [[nodiscard]] std::filesystem::path identity_path() const { return settings_.path / "identity"; }
  [[nodiscard]] std::string identity() const;
  [[nodiscard]] bool is_ours() const;
  [[nodiscard]] tl::expected<void, std::string> begin_anew();
  [[nodiscard]] tl::expected<void, std::string> open_database();
  [[nodiscard]] bool has_room();

  const ColumnCacheSettings settings_;
  const Logger log_;
  const Clock& clock_;
  std::unique_ptr<rocksdb::DB> db_;
  Counter found_, missing_, kept_, lost_;
  std::atomic<std::int64_t> read_ns_{0};       // recent average
  std::atomic<std::int64_t> disk_checked_at_;  // time of the last check, in nanoseconds of the clock
  std::atomic<bool> has_room_{true};
  std::atomic<bool> told_{false};  // a fault was logged
};

}  // namespace talus::server
