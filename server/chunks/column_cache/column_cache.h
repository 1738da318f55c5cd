// Columns of chunks as generated, on disk: what was dear to make is read again after a restart, or when
// memory has let it go. A cache: what is lost or damaged is made again, the oldest goes first, and nothing
// waits for the disk but who reads. Callable from any thread.
//
// docs/decisions/07-columns-on-disk.md says which columns are worth it, by a table of what they cost.
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
  std::filesystem::path path;  // a directory of its own, which it makes, and empties if it must
  ContentHash fingerprint;     // of the world
  std::uint64_t bytes = 0;     // on disk, about
  std::size_t memory_bytes = std::size_t{16} << 20U;  // for what is not written yet, and for what was read
  /// With less left on the disk nothing is kept: edits need it more.
  std::uint64_t free_bytes = std::uint64_t{1} << 30U;
};

class ColumnCache {
 public:
  /// What the cheapest column takes that is worth its place: half as much again as a read of a disk that
  /// nothing else uses.
  static constexpr std::chrono::microseconds kWorthKeeping{150};

  /// Begins anew where the directory holds columns of another world, or of another format, or is damaged. An
  /// error is one line: the directory cannot be written. `clock` outlives this.
  [[nodiscard]] static tl::expected<std::unique_ptr<ColumnCache>, std::string> open(
      const ColumnCacheSettings& settings, Logger log, const Clock& clock);
  /// What was not written yet is.
  ~ColumnCache();
  ColumnCache(const ColumnCache&) = delete;
  ColumnCache& operator=(const ColumnCache&) = delete;

  /// Whether a column that takes so long to make should be put().
  [[nodiscard]] bool worth(std::chrono::nanoseconds cost) const;

  /// Reads the disk. `column` is a column_of().
  [[nodiscard]] std::optional<ColumnRecord> find(ChunkKey column);

  /// Replaces what is kept of the column. Does not wait for the disk to write: where that is behind, the
  /// column is not kept.
  void put(ChunkKey column, const ColumnRecord& record);

  /// What was put is on the disk when it returns, but for what a failing disk did not take.
  void flush();

  struct Status {
    std::uint64_t found = 0;  // by find()
    std::uint64_t missing = 0;
    std::uint64_t kept = 0;        // by put()
    std::uint64_t lost = 0;        // damaged, or not kept as the disk was behind, full or failing
    std::uint64_t bytes = 0;       // on disk
    std::size_t memory_bytes = 0;  // of RocksDB
  };
  [[nodiscard]] Status status() const;

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
  std::atomic<std::int64_t> read_ns_{0};      // of late
  std::atomic<std::int64_t> looked_at_disk_;  // when, in nanoseconds of the clock
  std::atomic<bool> has_room_{true};
  std::atomic<bool> told_{false};  // the log, of a fault
};

}  // namespace talus::server
